package org.myrobotlab.service.sear.run;

import org.SEAR.devices.SerialLine;

/**
 * The short way between a device and a program outside that has its port: bytes pass neither MyRobotLab's messages nor the ports' reader threads,
 * each of which may have to wait for a busy processor. Any thread.
 */
public interface ExternalLine {
    /** Bytes of the program, on their way from the next step on. Never waits. */
    void write(byte[] bytes);

    /**
     * Who gets the bytes of the device, on the simulation thread; must not wait.
     *
     * @param reader null: they take the way through MyRobotLab again
     */
    void setReader(SerialLine.Sink reader);

    /** The first program has come. Never waits. */
    void pickUp();

    /** The last program has gone. Never waits. */
    void hangUp();

    /** The device's speed, bits a second. */
    int getDeviceBaud();
}
