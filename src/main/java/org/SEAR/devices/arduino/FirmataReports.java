package org.SEAR.devices.arduino;

import java.util.Arrays;
import java.util.function.DoubleConsumer;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.firmata.FirmataMessage;

/** What StandardFirmata tells unasked: levels of inputs when they change, voltages at each sample. */
final class FirmataReports {
    /** Longest time for which an echo is waited for, seconds: more would be a program that hangs. */
    static final double LONGEST_WAIT = 2;
    private static final int PORT = 8;
    private static final int SAMPLING_INTERVAL = 19;
    private static final double MILLISECOND = 0.001;
    /** Bytes that wait for the line before the program does. */
    private static final int SEND_BUFFER = 64;
    private static final double BITS_A_BYTE = 10;

    private final Firmware.Host host;
    private final Pins pins;
    private final BoardModel board;
    /** Inputs, by pin. */
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

    /** After a reset of the board. */
    void begin(double time) {
        interval = SAMPLING_INTERVAL;
        sampled = time;
    }

    /** Nothing is told any more; the time between samples stays. */
    void clear() {
        Arrays.fill(ports, false);
        Arrays.fill(channels, false);
        Arrays.fill(inputs, false);
        Arrays.fill(last, 0);
    }

    /** Whether a pin's level is read, and whether its voltage is. */
    void setInput(int pin, boolean digital, boolean analog) {
        inputs[pin] = digital;
        analogPins[pin] = analog;
    }

    /** @param millis time between samples, at least 1 */
    void setInterval(int millis) {
        interval = Math.max(1, millis);
    }

    /** Switches the report of a channel; when it is switched on, its voltage is told at once. */
    void setAnalog(int channel, boolean on, double time) {
        if (channel < channels.length) {
            channels[channel] = on;
            if (on) {
                sendAnalog(channel, time);
            }
        }
    }

    /** Switches the report of a port; when it is switched on, its levels are told at once. */
    void setPort(int port, boolean on, double time) {
        if (port < ports.length) {
            ports[port] = on;
            if (on) {
                sendPort(port, time, true);
            }
        }
    }

    private void sendAnalog(int channel, double time) {
        host.send(FirmataMessage.number(FirmataMessage.ANALOG, channel, pins.readAnalog(board.getFirstAnalog() + channel)).toBytes(), time);
    }

    /** Tells the levels of all reported ports that have changed. */
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
     * Tells voltages at each sample up to a time; none while the line has more than a buffer of bytes to send, in which a real program waits.
     *
     * @param also is told of each sample
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
