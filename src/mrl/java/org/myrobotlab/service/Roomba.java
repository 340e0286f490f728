// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.IOException;
import java.util.List;
import java.util.TreeSet;
import org.myrobotlab.framework.Service;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.config.RoombaConfig;
import org.slf4j.Logger;

/** Drives an iRobot Roomba or Create over its Open Interface. Any thread. */
public class Roomba extends Service<RoombaConfig> {
    public static final Logger log = LoggerFactory.getLogger(Roomba.class);

    private static final long serialVersionUID = 1L;
    private static final int START = 128;
    private static final int CONTROL = 130;
    private static final int POWER = 133;
    private static final int SPOT = 134;
    private static final int CLEAN = 135;
    private static final int DRIVE = 137;
    private static final int MOTORS = 138;
    private static final int LEDS = 139;
    private static final int SONG = 140;
    private static final int PLAY = 141;
    private static final int SENSORS = 142;
    private static final int SPIN_LEFT = 1;
    private static final int SPIN_RIGHT = -1;
    /** Radius value for straight driving. */
    private static final int STRAIGHT = -0x8000;
    /** Radius of a turn, mm. */
    private static final int TURN_RADIUS = 129;
    /** Default speed, mm/s. */
    private static final int DEFAULT_SPEED = 200;
    private static final int MAX_SPEED = 500;
    private static final int ROOMBA_BAUD = 57600;
    private static final int LATER_BAUD = 115200;
    private static final String OLD_PROTOCOL = "SCI";
    private static final String LATER_PROTOCOL = "OI";
    private static final int NOTE_SONG = 15;
    private static final int POWER_ORANGE = 128;
    private static final int FULL = 255;
    private static final int ALL_MOTORS = 7;
    private static final int LED_DIRT = 1;
    private static final int LED_MAX = 2;
    private static final int LED_CLEAN = 4;
    private static final int LED_SPOT = 8;
    private static final int LED_STATUS_RED = 16;
    private static final int LED_STATUS_GREEN = 32;
    private static final int NO_SENSORS = 0;
    private static final double MILLIS = 1000;
    /** Distance between the wheels, mm. */
    private static final double WHEEL_BASE = 258;
    /** The service through which all Roomba services talk, as in the real MyRobotLab. */
    private static final String SERIAL = "serial";

    private int speed = DEFAULT_SPEED;
    private String protocol = OLD_PROTOCOL;
    private String portName;
    private final transient Serial serial;

    public Roomba(String name, String id) {
        super(name, id);
        serial = (Serial) Runtime.start(SERIAL, "Serial");
    }

    // ---- connection
    // ---------------------------------------------------------------------------------------------------

    /**
     * Opens the port by the service named "serial", at 57600 baud (protocol OI: 115200), 8 data bits, 1 stop bit, no
     * parity, and closes it immediately, as the real MyRobotLab does since 2016. Connect the service named "serial"
     * afterwards.
     */
    public void connect(String port) {
        portName = port;
        try {
            serial.open(port, rate(), Byte.SIZE, 1, 0);
            serial.disconnect();
        } catch (IOException | IllegalStateException | IllegalArgumentException e) {
            TreeSet<String> known = new TreeSet<>(serial.getPortNames());
            known.remove(port);
            failCall("can't connect: %s; the ports are %s%s", e.getMessage(), known, notStarted());
        }
    }

    /**
     * Does nothing, as in the real MyRobotLab.
     *
     * @return false
     */
    public boolean connect(String port, int baud, int dataBits, int stopBits, int parity) {
        portName = port;
        failCall("connect with five arguments does nothing, as in every MyRobotLab; %s", remedy(baud));
        return false;
    }

    /** Returns the baud rate of the protocol. */
    private int rate() {
        return protocol.equals(LATER_PROTOCOL) ? LATER_BAUD : ROOMBA_BAUD;
    }

    private String remedy(int baud) {
        return "write Runtime.getService(\"" + SERIAL + "\").connect(\"" + (portName == null ? "PORT" : portName)
            + "\", " + baud + ", 8, 1, 0)";
    }

    /** Returns a hint if a SEAR service has not started its simulation, which creates the ports; else empty. */
    private static String notStarted() {
        return Runtime.getServices().stream().filter(one -> one.getSimpleName().equals("SEAR")
            && Boolean.FALSE.equals(one.invoke("isSimulating")))
            .map(one -> "; no simulation is running: " + one.getName() + ".startSimulation() creates its ports")
            .findFirst().orElse("");
    }

    /** @return false, as in the real MyRobotLab; the service named "serial" knows */
    public boolean connected() {
        return false;
    }

    /**
     * Closes the port of the service named "serial".
     *
     * @return true
     */
    public boolean disconnect() {
        serial.disconnect();
        return true;
    }

    public List<String> getPortNames() {
        return Serial.listPorts();
    }

    public String[] listPorts() {
        return getPortNames().toArray(new String[0]);
    }

    public String getPortname() {
        return portName;
    }

    public void setPortname(String port) {
        portName = port;
    }

    public String getProtocol() {
        return protocol;
    }

    /** @param newProtocol SCI for early Roombas, OI for later ones; sets the baud rate of the next connection */
    public void setProtocol(String newProtocol) {
        protocol = newProtocol;
    }

    /**
     * Sends bytes by the service named "serial".
     *
     * @return whether the bytes were sent
     */
    public boolean send(byte[] bytes) {
        try {
            if (!serial.isConnected()) {
                if (portName == null) {
                    failCall("is not connected: call connect(port) first, then %s", remedy(rate()));
                } else {
                    // no failure of the script: those of the dissertation do so
                    error("is not connected: MyRobotLab's Roomba closes its port after connect(port). After it, %s",
                        remedy(rate()));
                }
                return false;
            }
            serial.write(bytes);
            return true;
        } catch (Exception e) {
            failCall("can't send: %s", e.getMessage());
            return false;
        }
    }

    /** Sends the low 8 bits. */
    public boolean send(int value) {
        return send(new byte[] {(byte) value});
    }

    private void command(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        send(bytes);
    }

    // ---- modes
    // --------------------------------------------------------------------------------------------------------

    /** Wakes the interface: {@code 80}. */
    public void startup() {
        speed = DEFAULT_SPEED;
        command(START);
    }

    /** Takes control: {@code 82 8B 01 80 FF}. */
    public void control() {
        command(CONTROL);
        setLEDs(false, false, false, false, false, true, POWER_ORANGE, FULL);
    }

    /** Stops, starts up and takes control again. */
    public void reset() {
        stop();
        startup();
        control();
        updateSensors();
    }

    public void powerOff() {
        command(POWER);
    }

    public void spot() {
        command(SPOT);
    }

    public void clean() {
        command(CLEAN);
    }

    /** Switches all cleaning motors on or off. */
    public void vacuum(boolean on) {
        command(MOTORS, on ? ALL_MOTORS : 0);
    }

    /**
     * Requests all sensors.
     *
     * @return false; the reply goes to the port's listeners
     */
    public boolean updateSensors() {
        return updateSensors(NO_SENSORS);
    }

    /**
     * Requests a sensor packet.
     *
     * @return false; the reply goes to the port's listeners
     */
    public boolean updateSensors(int packet) {
        command(SENSORS, packet);
        return false;
    }

    /**
     * @param powerColor 0 green to 255 red
     * @param powerIntensity 0 to 255
     */
    public void setLEDs(boolean statusGreen, boolean statusRed, boolean spot, boolean clean, boolean max, boolean dirt,
        int powerColor, int powerIntensity) {
        int bits = (statusGreen ? LED_STATUS_GREEN : 0) | (statusRed ? LED_STATUS_RED : 0) | (spot ? LED_SPOT : 0)
            | (clean ? LED_CLEAN : 0) | (max ? LED_MAX : 0) | (dirt ? LED_DIRT : 0);
        command(LEDS, bits, powerColor, powerIntensity);
    }

    /**
     * @param note 31 to 127 as in MIDI
     * @param duration in 1/64 s
     */
    public void playNote(int note, int duration) {
        command(SONG, NOTE_SONG, 1, note, duration);
        command(PLAY, NOTE_SONG);
    }

    // ---- driving
    // ------------------------------------------------------------------------------------------------------

    /**
     * @param velocity mm/s, -500 to 500
     * @param radius mm, positive to the left; 1 turns left in place, -1 right, 0x8000 drives straight
     */
    public void drive(int velocity, int radius) {
        command(DRIVE, velocity >> Byte.SIZE, velocity, radius >> Byte.SIZE, radius);
    }

    public void stop() {
        drive(0, 0);
    }

    public int getSpeed() {
        return speed;
    }

    /** @param newSpeed mm/s, up to 500; speed of the commands without a speed */
    public void setSpeed(int newSpeed) {
        speed = Math.min(MAX_SPEED, Math.abs(newSpeed));
    }

    public void goForward() {
        goForwardAt(speed);
    }

    public void goForwardAt(int velocity) {
        goStraightAt(velocity);
    }

    public void goBackward() {
        goBackwardAt(speed);
    }

    public void goBackwardAt(int velocity) {
        goStraightAt(-velocity);
    }

    public void goStraightAt(int velocity) {
        drive(velocity, STRAIGHT);
    }

    /** Drives a distance in mm by the computer's clock, and stops. */
    public void goForward(int distance) {
        goStraight(distance);
    }

    /** Drives backward a distance in mm by the computer's clock, and stops. */
    public void goBackward(int distance) {
        goStraight(-distance);
    }

    /** Drives a distance in mm by the computer's clock, and stops; negative drives backward. */
    public void goStraight(int distance) {
        goStraightAt(distance < 0 ? -speed : speed);
        sleep(Math.round(Math.abs(distance) * MILLIS / speed));
        stop();
    }

    public void turn(int radius) {
        drive(speed, radius);
    }

    public void turnLeft() {
        turn(TURN_RADIUS);
    }

    public void turnRight() {
        turn(-TURN_RADIUS);
    }

    public void spinLeft() {
        spinLeftAt(speed);
    }

    public void spinRight() {
        spinRightAt(speed);
    }

    public void spinLeftAt(int velocity) {
        drive(velocity, SPIN_LEFT);
    }

    public void spinRightAt(int velocity) {
        drive(velocity, SPIN_RIGHT);
    }

    /** Turns in place by an angle in degrees, positive to the right, by the computer's clock, and stops. */
    public void spin(int angle) {
        drive(speed, angle < 0 ? SPIN_LEFT : SPIN_RIGHT);
        sleep(Math.round(Math.toRadians(Math.abs(angle)) * WHEEL_BASE / 2 * MILLIS / speed));
        stop();
    }

    public void spinLeft(int angle) {
        spin(-angle);
    }

    public void spinRight(int angle) {
        spin(angle);
    }
}
