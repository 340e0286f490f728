package org.myrobotlab.service.sear.export;

/** Where programs outside MyRobotLab come in to a port: made once, it stays while simulations come and go. Any thread. */
interface ExternalEndpoint {
    /** Starts taking bytes for {@code end}, which hears of every program that comes and goes. */
    void start(LineEnd end);

    /** Bytes for the program; lost if nobody reads them. Never waits. */
    void write(byte[] bytes);

    /**
     * A device has come to the port.
     *
     * @param baud its speed, which programs find there if none has set another
     */
    void deviceAt(int baud);

    /** What a program opens, in words, for example {@code "pseudo-terminal /dev/pts/3"}. */
    String describe();

    /** Ends it. */
    void close();
}
