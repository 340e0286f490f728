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
 * The pins of a board: what its program has set each to, and what that does to the things that hang on them. A pin that nothing drives floats: it has
 * any voltage, another one at each step, unless its pull-up resistor holds it. Simulation thread.
 */
public final class Pins {
    /** Steps of the analog inputs. */
    static final int ANALOG_STEPS = 1024;
    /** Greatest duty of pulses. */
    static final int FULL = 255;
    /** Share of the supply from which on a level is high: data sheet of the ATmega328P. */
    private static final double HIGH = 0.6;
    /** Time from one servo pulse to the next, us. */
    private static final double SERVO_PERIOD = 20000;
    private static final double STEPS_A_SECOND = 60;
    private static final double PERCENT = 100;

    /** What a pin is set to. */
    enum Mode { INPUT, PULLUP, OUTPUT, PWM, SERVO }

    private static final PinWire NOTHING = () -> "";

    private final BoardModel board;
    private final DeviceContext context;
    private final String name;
    private final Mode[] modes;
    private final int[] values;
    private final PinWire[] wires;
    private CounterRandom random;

    /** Nothing is wired; all pins are inputs. */
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

    /** Whether there is such a pin. */
    boolean has(int pin) {
        return pin >= 0 && pin < modes.length;
    }

    /** All pins as after a reset: inputs. */
    void release() {
        random = new CounterRandom(context.seed(), name);
        for (int pin = 0; pin < modes.length; pin++) {
            setMode(pin, Mode.INPUT);
        }
    }

    Mode mode(int pin) {
        return modes[pin];
    }

    /** Sets a pin to a mode; an output is low then. */
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

    /** Writes a level; at an input it switches the pull-up resistor. */
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
     * Puts pulses on a pin; one that has none for them is high from half the duty on.
     *
     * @param duty 0 to 255; what is beyond counts as the nearest of these
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

    /** Volts of a pin against ground, of pulses their mean. */
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

    /** The level of a pin. */
    boolean read(int pin) {
        return volts(pin) >= HIGH * BoardModel.VOLTS;
    }

    /** The voltage of a pin, 0 to 1023 for 0 to 5 V. */
    int readAnalog(int pin) {
        return (int) Math.max(0, Math.min(ANALOG_STEPS - 1, Math.floor(volts(pin) * ANALOG_STEPS / BoardModel.VOLTS)));
    }

    /**
     * How long the echo takes that a pulse at one pin brings to another, or to the same.
     *
     * @return seconds, +infinity if none comes
     */
    double echo(int trigger, int listened) {
        double seconds = wires[trigger].echo(wires[listened]);
        return Double.isNaN(seconds) ? Double.POSITIVE_INFINITY : seconds;
    }

    /** The encoder at two pins; null if there is none. */
    PinWire.Encoder encoder(int first, int second) {
        return wires[first].encoder(wires[second]);
    }

    /** Whether a range sensor answers at the pin that starts it. */
    boolean hasEcho(int pin) {
        return !Double.isNaN(wires[pin].echo(wires[pin]));
    }

    /** What hangs on the pins, and what is there now, for people. */
    List<PinState> states() {
        List<PinState> states = new ArrayList<>();
        for (int pin = 0; pin < wires.length; pin++) {
            if (wires[pin] != NOTHING) {
                states.add(new PinState(board.nameOf(pin), wires[pin].describe(), modes[pin].name().toLowerCase(Locale.ROOT), value(pin)));
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
