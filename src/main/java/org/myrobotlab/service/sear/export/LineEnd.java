package org.myrobotlab.service.sear.export;

/**
 * What one {@link ExternalEndpoint} knows of the line: its programs' bytes and baud rate. Several of one port share the line, but each has a rate of
 * its own: that of the one holds which was opened, set or written to last. Any thread.
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

    /** The rate that a program has set; 0 for the device's own, whatever that is. */
    int getBaud() {
        return baud;
    }

    /** A program has come. */
    void opened() {
        bridge.use(this);
    }

    /** The last program has gone. */
    void closed() {
        bridge.leave(this);
    }

    /** A program has set its speed; 0 for the device's own. */
    void setBaud(int newBaud) {
        baud = newBaud;
        bridge.changed(this);
    }

    /** Bytes of a program; holds it up while the line is full, as a real port does. */
    void send(byte[] bytes) {
        bridge.use(this);
        bridge.send(bytes);
    }

    /** Something the user should know, once for each cause; the export is named before it. */
    void warn(String cause, String message) {
        bridge.warn(cause, bridge.getName() + ": " + message);
    }

    /** The speed of the line as a program is told it: its own, else the device's; 0 if nothing runs. */
    int getLineBaud() {
        return baud > 0 ? baud : bridge.getDeviceBaud();
    }
}
