// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

/**
 * The side of one {@link ExternalEndpoint} towards the line: its programs' bytes and baud rate. Several endpoints of a
 * port share the line, but each has its own rate. The rate of the endpoint last opened, set or written to is in force.
 * Any thread.
 */
final class LineEnd {
    private final PortBridge bridge;
    private final ExternalEndpoint endpoint;
    private volatile int baud;

    LineEnd(PortBridge bridge, ExternalEndpoint endpoint) {
        this.bridge = bridge;
        this.endpoint = endpoint;
    }

    ExternalEndpoint getEndpoint() {
        return endpoint;
    }

    /** Returns the rate that a program has set; 0 for the device's own. */
    int getBaud() {
        return baud;
    }

    /** Reports that a program has opened the endpoint. */
    void opened() {
        bridge.use(this);
    }

    /** Reports that the last program has closed the endpoint. */
    void closed() {
        bridge.leave(this);
    }

    /** Sets the programs' baud rate; 0 for the device's own. */
    void setBaud(int newBaud) {
        baud = newBaud;
        bridge.changed(this);
    }

    /** Sends bytes of a program; blocks it while the line is full, as a real port does. */
    void send(byte[] bytes) {
        bridge.use(this);
        bridge.send(bytes);
    }

    /** Warns the user once per cause; prefixes the export's name. */
    void warn(String cause, String message) {
        bridge.warn(cause, bridge.getName() + ": " + message);
    }

    /** Counts messages that a program which reads too slowly has lost, and warns the user. */
    void lost(int messages) {
        for (int i = 0; i < messages; i++) {
            warn("unread at " + endpoint.describe(), "the program at the " + endpoint.describe()
                + " reads too slowly; SEAR drops whole messages while an earlier one waits");
        }
    }

    /** Returns the baud rate for a program: its own, else the device's; 0 without a device. */
    int getLineBaud() {
        return baud > 0 ? baud : bridge.getDeviceBaud();
    }
}
