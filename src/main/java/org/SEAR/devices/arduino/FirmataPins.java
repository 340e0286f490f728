// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.Arrays;
import java.util.function.Consumer;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.PinUse;
import org.SEAR.protocol.firmata.PinMode;

/** Modes and values of the pins in StandardFirmata. */
final class FirmataPins {
    /** Default pulse lengths of a servo, us: shortest and longest of the Servo library. */
    static final int SHORTEST = 544;
    static final int LONGEST = 2400;
    private static final int HALF_TURN = 180;
    private static final int PORT = 8;

    private final Pins pins;
    private final BoardModel board;
    private final FirmataReports reports;
    private final Consumer<String> texts;
    private final PinMode[] modes;
    private final int[] states;
    private final int[] shortest;
    private final int[] longest;
    private boolean resetting;

    /** @param texts receives messages for the user */
    FirmataPins(Pins pins, FirmataReports reports, Consumer<String> texts) {
        this.pins = pins;
        this.board = pins.board();
        this.reports = reports;
        this.texts = texts;
        this.modes = new PinMode[board.getPins()];
        this.states = new int[modes.length];
        this.shortest = new int[modes.length];
        this.longest = new int[modes.length];
    }

    /** Makes analog pins inputs and all other pins low outputs. */
    void reset() {
        resetting = true;
        Arrays.fill(modes, PinMode.INPUT);
        Arrays.fill(states, 0);
        for (int pin = 0; pin < modes.length; pin++) {
            setMode(pin, board.can(pin, PinUse.ANALOG) ? PinMode.ANALOG.getCode() : PinMode.OUTPUT.getCode(), 0);
        }
        resetting = false;
    }

    /** Whether a pin supports a mode. */
    boolean can(int pin, PinMode mode) {
        switch (mode) {
            case ANALOG:
                return board.can(pin, PinUse.ANALOG);
            case PWM:
                return board.can(pin, PinUse.PWM);
            case SERVO:
                return board.can(pin, PinUse.SERVO);
            case I2C:
                return board.can(pin, PinUse.I2C);
            default:
                return board.can(pin, PinUse.DIGITAL);
        }
    }

    PinMode mode(int pin) {
        return modes[pin];
    }

    /** Value written last; 1 for an input with its pull-up on. */
    int state(int pin) {
        return states[pin];
    }

    /** @param code of the mode; an unsupported one changes nothing */
    void setMode(int pin, int code, double time) {
        PinMode mode = PinMode.of(code);
        if (pin >= modes.length || mode == null) {
            if (mode == null && pin < modes.length) {
                texts.accept("Unknown pin mode");
            }
            return;
        }
        if (!can(pin, mode)) {
            return;
        }
        modes[pin] = mode;
        states[pin] = mode == PinMode.PULLUP ? 1 : 0;
        reports.setInput(pin, mode == PinMode.INPUT || mode == PinMode.PULLUP, mode == PinMode.ANALOG);
        apply(pin, mode);
        if (board.channelOf(pin) >= 0 && !resetting) {
            reports.setAnalog(board.channelOf(pin), mode == PinMode.ANALOG, time);
        }
    }

    private void apply(int pin, PinMode mode) {
        switch (mode) {
            case OUTPUT:
                pins.setMode(pin, Pins.Mode.OUTPUT);
                break;
            case PWM:
                pins.writeDuty(pin, 0);
                break;
            case PULLUP:
                pins.setMode(pin, Pins.Mode.PULLUP);
                break;
            case SERVO:
                shortest[pin] = SHORTEST;
                longest[pin] = LONGEST;
                pins.setMode(pin, Pins.Mode.SERVO);
                break;
            default:
                pins.setMode(pin, Pins.Mode.INPUT);
                break;
        }
    }

    /** Attaches a servo with a range of pulses, us, to a pin. */
    void attachServo(int pin, int from, int to) {
        if (pin < modes.length && can(pin, PinMode.SERVO)) {
            setMode(pin, PinMode.SERVO.getCode(), 0);
            shortest[pin] = from;
            longest[pin] = Math.max(from, to);
        }
    }

    /** Sets the levels of a port's outputs; at an input, a 1 switches the pull-up on. */
    void writePort(int port, int bits) {
        for (int i = 0; i < PORT && PORT * port + i < modes.length; i++) {
            int pin = PORT * port + i;
            boolean high = (bits >> i & 1) != 0;
            if (modes[pin] == PinMode.OUTPUT) {
                writeLevel(pin, high);
            } else if (modes[pin] == PinMode.INPUT && board.can(pin, PinUse.DIGITAL)) {
                states[pin] = high ? 1 : 0;
                pins.setMode(pin, high || pins.mode(pin) == Pins.Mode.PULLUP ? Pins.Mode.PULLUP : Pins.Mode.INPUT);
            }
        }
    }

    void writeLevel(int pin, boolean high) {
        if (pin < modes.length && modes[pin] == PinMode.OUTPUT && board.can(pin, PinUse.DIGITAL)) {
            states[pin] = high ? 1 : 0;
            pins.write(pin, high);
        }
    }

    /** Sets a PWM pin's duty, or a servo's angle in degrees; values of at least {@link #SHORTEST} are a pulse in us. */
    void writeAnalog(int pin, int value) {
        if (pin >= modes.length) {
            return;
        }
        if (modes[pin] == PinMode.PWM) {
            states[pin] = value;
            pins.writeDuty(pin, value);
        } else if (modes[pin] == PinMode.SERVO) {
            states[pin] = value;
            int range = longest[pin] - shortest[pin];
            int micros = value < SHORTEST ? shortest[pin] + Math.min(value, HALF_TURN) * range / HALF_TURN : value;
            pins.writePulse(pin, Math.max(shortest[pin], Math.min(longest[pin], micros)));
        }
    }
}
