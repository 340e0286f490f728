// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.io.ByteArrayOutputStream;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.PinUse;
import org.SEAR.protocol.firmata.EchoMessage;
import org.SEAR.protocol.firmata.Feature;
import org.SEAR.protocol.firmata.FirmataMessage;
import org.SEAR.protocol.firmata.FirmataReader;
import org.SEAR.protocol.firmata.PinMode;

/**
 * StandardFirmata 2.5 with the features for encoders (61h) and for echoes of range sensors (75h). After a reset it
 * blinks its version, then sends it with its name. Source: behaviour of StandardFirmata.ino, protocol.md and
 * encoder.md.
 */
final class FirmataFirmware implements Firmware {
    static final String NAME = "StandardFirmata.ino";
    /** Duration of two and five blinks of the LED at pin 13, seconds. */
    static final double BLINKING = 2.125;
    private static final int MAJOR = 2;
    private static final int MINOR = 5;
    private static final int END_OF_PIN = 0x7F;
    private static final int ECHO_RESOLUTION = 1;
    private static final double MICROSECOND = 1e-6;
    private static final int BITS = 7;
    private static final int ENCODER_MODE = 0x09;
    private static final int ENCODER_RESOLUTION = 28;
    private static final int I2C_READS = 0x18;

    private final Host host;
    private final Pins pins;
    private final BoardModel board;
    private final FirmataPins states;
    private final FirmataReports reports;
    private final FirmataEncoders encoders;
    private final FirmataReader reader = new FirmataReader(FirmataReader.BOARD, this::execute);
    private double now;

    FirmataFirmware(Host host) {
        this.host = host;
        this.pins = host.pins();
        this.board = pins.board();
        this.reports = new FirmataReports(host);
        this.states = new FirmataPins(pins, reports, this::say);
        this.encoders = new FirmataEncoders(pins);
    }

    @Override
    public void setUp(double time, boolean silent) {
        now = time;
        reader.clear();
        reports.begin(time);
        forgetAll();
        if (!silent) {
            host.busy(time + BLINKING);
            now = time + BLINKING;
            reportVersion();
            reportFirmware();
        }
    }

    private void forgetAll() {
        reports.clear();
        encoders.clear();
        states.reset();
    }

    @Override
    public void receive(int value, double time) {
        now = time;
        reader.accept(value);
    }

    @Override
    public void advance(double time) {
        now = time;
        reports.levels(time, false);
        reports.samples(time, sampled -> encoders.reportAutomatic(message -> host.send(message.toBytes(), sampled)));
    }

    private void send(FirmataMessage message) {
        host.send(message.toBytes(), now);
    }

    private void say(String text) {
        send(FirmataMessage.text(Feature.STRING, new int[0], text));
    }

    /**
     * Whether a message identifies a Firmata host. A Create's commands often look like writes and reports; only these
     * messages differ from all other devices' commands.
     */
    private static boolean isTelling(FirmataMessage message) {
        int command = message.getCommand();
        return command == FirmataMessage.VERSION || command == FirmataMessage.PIN_MODE
            || command == FirmataMessage.START_SYSEX;
    }

    private void execute(FirmataMessage message) {
        if (isTelling(message)) {
            host.understood();
        }
        switch (message.getCommand()) {
            case FirmataMessage.DIGITAL:
                states.writePort(message.getChannel(), message.getNumber(0));
                break;
            case FirmataMessage.ANALOG:
                states.writeAnalog(message.getChannel(), message.getNumber(0));
                break;
            case FirmataMessage.REPORT_ANALOG:
                reports.setAnalog(message.getChannel(), message.get(0) != 0, now);
                break;
            case FirmataMessage.REPORT_DIGITAL:
                reports.setPort(message.getChannel(), message.get(0) != 0, now);
                break;
            case FirmataMessage.PIN_MODE:
                states.setMode(message.get(0), message.get(1), now);
                break;
            case FirmataMessage.PIN_VALUE:
                states.writeLevel(message.get(0), message.get(1) != 0);
                break;
            case FirmataMessage.VERSION:
                reportVersion();
                break;
            case FirmataMessage.RESET:
                forgetAll();
                break;
            default:
                executeSysex(message);
                break;
        }
    }

    private void executeSysex(FirmataMessage message) {
        switch (message.getId()) {
            case Feature.FIRMWARE:
                reportFirmware();
                break;
            case Feature.CAPABILITY_QUERY:
                reportCapabilities();
                break;
            case Feature.ANALOG_MAPPING_QUERY:
                reportAnalogMapping();
                break;
            case Feature.PIN_STATE_QUERY:
                reportState(message);
                break;
            case Feature.EXTENDED_ANALOG:
                if (message.size() > 1) {
                    states.writeAnalog(message.get(0), message.getNumber(1) | message.get(3) << 2 * BITS);
                }
                break;
            case Feature.SERVO_CONFIG:
                if (message.size() > 4) {
                    states.attachServo(message.get(0), message.getNumber(1), message.getNumber(3));
                }
                break;
            case Feature.SAMPLING_INTERVAL:
                if (message.size() > 1) {
                    reports.setInterval(message.getNumber(0));
                }
                break;
            case Feature.I2C_REQUEST:
                refuseI2c(message);
                break;
            case Feature.ECHO:
                answerEcho(message);
                break;
            case Feature.ENCODER:
                encoders.execute(message, this::send);
                break;
            default:
                break;
        }
    }

    private void reportVersion() {
        send(FirmataMessage.of(FirmataMessage.VERSION, MAJOR, MINOR));
    }

    private void reportFirmware() {
        send(FirmataMessage.text(Feature.FIRMWARE, new int[] {MAJOR, MINOR}, NAME));
    }

    private void reportCapabilities() {
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        for (int pin = 0; pin < board.getPins(); pin++) {
            for (PinMode mode : PinMode.values()) {
                if (states.can(pin, mode)) {
                    data.write(mode.getCode());
                    data.write(mode.getResolution());
                }
            }
            if (encoders.isTrack(pin)) {
                data.write(ENCODER_MODE);
                data.write(ENCODER_RESOLUTION);
            }
            if (pins.hasEcho(pin)) {
                data.write(Feature.ECHO);
                data.write(ECHO_RESOLUTION);
            }
            data.write(END_OF_PIN);
        }
        send(FirmataMessage.sysex(Feature.CAPABILITY_RESPONSE, ints(data)));
    }

    private static int[] ints(ByteArrayOutputStream data) {
        byte[] bytes = data.toByteArray();
        int[] values = new int[bytes.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = bytes[i];
        }
        return values;
    }

    private void reportAnalogMapping() {
        int[] channels = new int[board.getPins()];
        for (int pin = 0; pin < channels.length; pin++) {
            channels[pin] = board.can(pin, PinUse.ANALOG) ? board.channelOf(pin) : END_OF_PIN;
        }
        send(FirmataMessage.sysex(Feature.ANALOG_MAPPING_RESPONSE, channels));
    }

    private void reportState(FirmataMessage question) {
        int pin = question.get(0);
        if (question.size() == 0) {
            return;
        }
        if (!pins.has(pin)) {
            send(FirmataMessage.sysex(Feature.PIN_STATE_RESPONSE, pin));
            return;
        }
        int state = states.state(pin);
        int mode = states.mode(pin).getCode();
        if (state >> 2 * BITS != 0) {
            send(FirmataMessage.sysex(Feature.PIN_STATE_RESPONSE, pin, mode, state, state >> BITS, state >> 2 * BITS));
        } else if (state >> BITS != 0) {
            send(FirmataMessage.sysex(Feature.PIN_STATE_RESPONSE, pin, mode, state, state >> BITS));
        } else {
            send(FirmataMessage.sysex(Feature.PIN_STATE_RESPONSE, pin, mode, state));
        }
    }

    /** Warns of an I2C request, because no device is on the bus. */
    private void refuseI2c(FirmataMessage request) {
        host.warn("I2C", "SEAR has no devices for its I2C bus; reads get no answer");
        if ((request.get(1) & I2C_READS) != 0) {
            say("I2C: Too few bytes received");
        }
    }

    /** Measures an echo. The program is busy meanwhile. */
    private void answerEcho(FirmataMessage request) {
        int pin = request.get(0);
        if (!EchoMessage.isRequest(request) || !pins.has(pin)) {
            return;
        }
        double timeout = EchoMessage.timeout(request) * MICROSECOND;
        double echo = pins.echo(pin, pin);
        boolean heard = echo <= timeout;
        now += heard ? echo : Math.min(timeout, FirmataReports.LONGEST_WAIT);
        host.busy(now);
        send(EchoMessage.answer(pin, heard ? Math.round(echo / MICROSECOND) : 0));
    }

    @Override
    public String status() {
        return reports.status();
    }
}
