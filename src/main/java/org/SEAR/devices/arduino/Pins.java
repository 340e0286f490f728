// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.PinState;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.PinUse;
import org.SEAR.sensors.CounterRandom;

/**
 * Pins of a board: their modes and values, and their effects on the connected components. An undriven pin floats at a
 * random voltage that changes each step, unless its pull-up resistor is on. Simulation thread.
 */
public final class Pins {
    /** Resolution of the analog inputs, steps. */
    static final int ANALOG_STEPS = 1024;
    /** Maximum PWM duty. */
    static final int FULL = 255;
    /** Lowest share of the supply voltage that reads as high. Source: data sheet of the ATmega328P. */
    private static final double HIGH = 0.6;
    /** Period of servo pulses, us. */
    private static final double SERVO_PERIOD = 20000;
    private static final double STEPS_A_SECOND = 60;
    private static final double PERCENT = 100;

    enum Mode { INPUT, PULLUP, OUTPUT, PWM, SERVO }

    private static final PinWire NOTHING = () -> "";

    private final BoardModel board;
    private final DeviceContext context;
    private final String name;
    private final Mode[] modes;
    private final int[] values;
    private final PinWire[] wires;
    private CounterRandom random;

    /** Creates pins without wires, all of them inputs. */
    Pins(BoardModel board, String name, DeviceContext context) {
        this.board = board;
        this.context = context;
        this.name = name;
        this.random = new CounterRandom(context.seed(), name);
        this.modes = new Mode[board.getPins()];
        this.values = new int[board.getPins()];
        this.wires = new PinWire[board.getPins()];
        Arrays.fill(wires, NOTHING);
        Arrays.fill(modes, Mode.INPUT);
    }

    void connect(int pin, PinWire wire) {
        wires[pin] = wire;
    }

    BoardModel board() {
        return board;
    }

    boolean has(int pin) {
        return pin >= 0 && pin < modes.length;
    }

    /** Makes all pins inputs, as after a reset. */
    void release() {
        random = new CounterRandom(context.seed(), name);
        for (int pin = 0; pin < modes.length; pin++) {
            setMode(pin, Mode.INPUT);
        }
    }

    Mode mode(int pin) {
        return modes[pin];
    }

    /** Sets the mode of a pin; an output is low then. */
    void setMode(int pin, Mode mode) {
        if (modes[pin] == Mode.SERVO && mode != Mode.SERVO) {
            wires[pin].pulse(0);
        }
        modes[pin] = mode;
        values[pin] = 0;
        if (mode == Mode.INPUT || mode == Mode.PULLUP) {
            wires[pin].pull(mode == Mode.PULLUP);
        } else {
            wires[pin].drive(0);
        }
    }

    /** Writes a level; at an input, it switches the pull-up resistor. */
    void write(int pin, boolean high) {
        if (modes[pin] == Mode.INPUT || modes[pin] == Mode.PULLUP) {
            modes[pin] = high ? Mode.PULLUP : Mode.INPUT;
            wires[pin].pull(high);
            return;
        }
        if (modes[pin] == Mode.SERVO) {
            wires[pin].pulse(0);
        }
        modes[pin] = Mode.OUTPUT;
        values[pin] = high ? 1 : 0;
        wires[pin].drive(values[pin]);
    }

    /**
     * Sets the PWM duty of a pin. A pin without PWM is high above half the duty.
     *
     * @param duty 0 to 255; other values are clamped
     */
    void writeDuty(int pin, int duty) {
        int legal = Math.max(0, Math.min(FULL, duty));
        if (!board.can(pin, PinUse.PWM)) {
            setMode(pin, Mode.OUTPUT);
            write(pin, legal > FULL / 2);
            return;
        }
        if (modes[pin] != Mode.PWM) {
            setMode(pin, Mode.PWM);
        }
        values[pin] = legal;
        wires[pin].drive(legal / (double) FULL);
    }

    /** @param micros length of the servo pulses; 0 for none */
    void writePulse(int pin, int micros) {
        if (modes[pin] != Mode.SERVO) {
            setMode(pin, Mode.SERVO);
        }
        values[pin] = micros;
        wires[pin].pulse(micros);
    }

    /** Voltage of a pin against ground, V; the mean for pulses. */
    double volts(int pin) {
        switch (modes[pin]) {
            case OUTPUT:
                return BoardModel.VOLTS * values[pin];
            case PWM:
                return BoardModel.VOLTS * values[pin] / FULL;
            case SERVO:
                return BoardModel.VOLTS * values[pin] / SERVO_PERIOD;
            default:
                double volts = wires[pin].volts();
                return !Double.isNaN(volts) ? volts : modes[pin] == Mode.PULLUP ? BoardModel.VOLTS : floating(pin);
        }
    }

    private double floating(int pin) {
        return BoardModel.VOLTS * random.uniform(Math.round(context.time() * STEPS_A_SECOND), pin, 0);
    }

    /** Whether nothing drives a pin. */
    boolean floats(int pin) {
        return modes[pin] == Mode.INPUT && Double.isNaN(wires[pin].volts());
    }

    /** Reads the level of a pin. */
    boolean read(int pin) {
        return volts(pin) >= HIGH * BoardModel.VOLTS;
    }

    /** Reads the voltage of a pin, 0 to 1023 for 0 to 5 V. */
    int readAnalog(int pin) {
        return (int) Math.max(0, Math.min(ANALOG_STEPS - 1, Math.floor(volts(pin) * ANALOG_STEPS / BoardModel.VOLTS)));
    }

    /**
     * Delay between a pulse at one pin and its echo at another, or at the same.
     *
     * @return seconds, +infinity without an echo
     */
    double echo(int trigger, int listened) {
        double seconds = wires[trigger].echo(wires[listened]);
        return Double.isNaN(seconds) ? Double.POSITIVE_INFINITY : seconds;
    }

    /** The encoder at two pins; null if there is none. */
    PinWire.Encoder encoder(int first, int second) {
        return wires[first].encoder(wires[second]);
    }

    /** Whether a range sensor answers at its trigger pin. */
    boolean hasEcho(int pin) {
        return !Double.isNaN(wires[pin].echo(wires[pin]));
    }

    /** State of the connected pins, as text for users. */
    List<PinState> states() {
        List<PinState> states = new ArrayList<>();
        for (int pin = 0; pin < wires.length; pin++) {
            if (wires[pin] != NOTHING) {
                states.add(new PinState(board.nameOf(pin), wires[pin].describe(), modes[pin].name()
                    .toLowerCase(Locale.ROOT), value(pin)));
            }
        }
        return states;
    }

    private String value(int pin) {
        switch (modes[pin]) {
            case OUTPUT:
                return values[pin] == 0 ? "low" : "high";
            case PWM:
                return Math.round(PERCENT * values[pin] / FULL) + " %";
            case SERVO:
                return values[pin] + " us";
            default:
                return floats(pin) ? "floats" : String.format(Locale.ROOT, "%.2f V", volts(pin));
        }
    }
}
