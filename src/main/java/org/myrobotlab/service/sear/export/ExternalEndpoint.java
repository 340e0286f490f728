// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

/** An access point for external programs to a port. It outlives simulations. Any thread. */
interface ExternalEndpoint {
    /** Starts delivering bytes and the programs' opening and closing to {@code end}. */
    void start(LineEnd end);

    /**
     * Sends bytes to the program; drops them without a reader, and whole messages if the program reads too slowly.
     * Never waits. One thread at a time.
     *
     * @param starts indices of the messages' first bytes, as in {@link org.SEAR.devices.SerialLine.Sink}
     */
    void write(byte[] bytes, int[] starts);

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
