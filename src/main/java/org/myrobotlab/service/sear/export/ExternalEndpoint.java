package org.myrobotlab.service.sear.export;

import java.util.function.Consumer;
import java.util.function.IntConsumer;

/** Where a program outside MyRobotLab comes in to a port. */
interface ExternalEndpoint {
    /**
     * Starts taking bytes.
     *
     * @param bytes gets what the program sends
     * @param baud gets the rate the program sets, where one can be set
     */
    void start(Consumer<byte[]> bytes, IntConsumer baud);

    /** Bytes for the program; lost if nobody reads them. Never waits. */
    void write(byte[] bytes);

    /** Ends it. */
    void close();
}
