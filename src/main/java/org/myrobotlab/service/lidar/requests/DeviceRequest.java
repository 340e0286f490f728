// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar.requests;

import java.util.function.Supplier;

/** A request to a device: the bytes to send and the time-out of the reply. */
public class DeviceRequest {
    /** Name for messages. */
    public final String name;
    /** Supplies the bytes when the request is sent: later requests of a series depend on earlier replies. */
    public final Supplier<byte[]> bytes;
    /** Bytes of the whole reply, to add its time on the line; 0 if there is none. */
    public final int replyLength;
    /** Seconds that the device may take before it replies; without a reply, seconds until the next request. */
    public final double timeout;

    /**
     * @param replyLength bytes; 0 if there is no reply
     * @param patience seconds
     */
    protected DeviceRequest(String name, Supplier<byte[]> bytes, int replyLength, double patience) {
        this.name = name;
        this.bytes = bytes;
        this.replyLength = replyLength;
        this.timeout = patience;
    }
}
