// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.Arrays;
import java.util.function.DoubleConsumer;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.firmata.FirmataMessage;

/** Unsolicited messages of StandardFirmata: changed levels of inputs, and voltages at each sample. */
final class FirmataReports {
    /** Longest wait for an echo, seconds; a longer wait would look like a crash. */
    static final double LONGEST_WAIT = 2;
    private static final int PORT = 8;
    private static final int SAMPLING_INTERVAL = 19;
    private static final double MILLISECOND = 0.001;
    /** Size of the send buffer; the program waits when more bytes are queued. */
    private static final int SEND_BUFFER = 64;
    private static final double BITS_A_BYTE = 10;

    private final Firmware.Host host;
    private final Pins pins;
    private final BoardModel board;
    /** Whether a pin is a digital input. */
    private final boolean[] inputs;
    private final boolean[] analogPins;
    private final boolean[] ports;
    private final int[] last;
    private final boolean[] channels;
    private int interval = SAMPLING_INTERVAL;
    private double sampled;

    FirmataReports(Firmware.Host host) {
        this.host = host;
        this.pins = host.pins();
        this.board = pins.board();
        this.inputs = new boolean[board.getPins()];
        this.analogPins = new boolean[board.getPins()];
        this.ports = new boolean[(board.getPins() + PORT - 1) / PORT];
        this.last = new int[ports.length];
        this.channels = new boolean[board.getAnalogs()];
    }

    /** Restarts the sampling after a reset of the board. */
    void begin(double time) {
        interval = SAMPLING_INTERVAL;
        sampled = time;
    }

    /** Switches all reports off; the sampling interval stays. */
    void clear() {
        Arrays.fill(ports, false);
        Arrays.fill(channels, false);
        Arrays.fill(inputs, false);
        Arrays.fill(last, 0);
    }

    /** Sets whether a pin's level and its voltage are read. */
    void setInput(int pin, boolean digital, boolean analog) {
        inputs[pin] = digital;
        analogPins[pin] = analog;
    }

    /** @param millis sampling interval, at least 1 */
    void setInterval(int millis) {
        interval = Math.max(1, millis);
    }

    /** Switches the reports of a channel; switching on sends its voltage immediately. */
    void setAnalog(int channel, boolean on, double time) {
        if (channel < channels.length) {
            channels[channel] = on;
            if (on) {
                sendAnalog(channel, time);
            }
        }
    }

    /** Switches the reports of a port; switching on sends its levels immediately. */
    void setPort(int port, boolean on, double time) {
        if (port < ports.length) {
            ports[port] = on;
            if (on) {
                sendPort(port, time, true);
            }
        }
    }

    private void sendAnalog(int channel, double time) {
        host.send(FirmataMessage.number(FirmataMessage.ANALOG, channel,
            pins.readAnalog(board.getFirstAnalog() + channel)).toBytes(), time);
    }

    /**
     * Sends the levels of all reported ports that have changed.
     *
     * @param always whether to send unchanged ports, too
     */
    void levels(double time, boolean always) {
        for (int port = 0; port < ports.length; port++) {
            if (ports[port]) {
                sendPort(port, time, always);
            }
        }
    }

    private void sendPort(int port, double time, boolean always) {
        int bits = 0;
        for (int i = 0; i < PORT && PORT * port + i < inputs.length; i++) {
            if (inputs[PORT * port + i] && pins.read(PORT * port + i)) {
                bits |= 1 << i;
            }
        }
        if (always || bits != last[port]) {
            host.send(FirmataMessage.number(FirmataMessage.DIGITAL, port, bits).toBytes(), time);
            last[port] = bits;
        }
    }

    /**
     * Sends voltages at each sample up to a time. Skips samples while the line has more than a buffer of bytes queued,
     * during which a real program waits.
     *
     * @param also receives the time of each sample
     */
    void samples(double time, DoubleConsumer also) {
        double step = interval * MILLISECOND;
        while (sampled + step <= time) {
            sampled += step;
            if (isLineFull(sampled)) {
                continue;
            }
            for (int channel = 0; channel < channels.length; channel++) {
                if (channels[channel] && analogPins[board.getFirstAnalog() + channel]) {
                    sendAnalog(channel, sampled);
                }
            }
            also.accept(sampled);
        }
    }

    private boolean isLineFull(double time) {
        return host.lineFreeAt() - time > SEND_BUFFER * BITS_A_BYTE / host.getBaud();
    }

    String status() {
        int analog = 0;
        for (boolean each : channels) {
            analog += each ? 1 : 0;
        }
        int digital = 0;
        for (boolean each : ports) {
            digital += each ? 1 : 0;
        }
        return analog + " analog channels and " + digital + " ports reported, every " + interval + " ms";
    }
}
