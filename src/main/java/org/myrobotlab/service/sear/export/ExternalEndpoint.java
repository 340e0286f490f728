package org.myrobotlab.service.sear.export;

/** An access point for external programs to a port. It outlives simulations. Any thread. */
interface ExternalEndpoint {
    /** Starts delivering bytes and the programs' opening and closing to {@code end}. */
    void start(LineEnd end);

    /** Sends bytes to the program; drops them without a reader. Never waits. */
    void write(byte[] bytes);

    /**
     * Reports that a device is present at the port.
     *
     * @param baud its baud rate, which programs see unless one has set another
     */
    void deviceAt(int baud);

    /** Returns a description of what a program opens, for example {@code "pseudo-terminal /dev/pts/3"}. */
    String describe();

    void close();
}
