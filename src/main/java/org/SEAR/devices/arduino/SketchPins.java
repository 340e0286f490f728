// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.PinState;
import org.SEAR.devices.arduino.avr.Atmega328p;
import org.SEAR.devices.arduino.avr.Surroundings.Drive;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.sensors.CounterRandom;

/**
 * Pins of an Uno that runs a compiled sketch, with the connected components. Echoes and encoder edges arrive within a
 * step at their own time. Other inputs change once per step. Components get the outputs when a part of a step ends.
 * Simulation thread.
 */
final class SketchPins {
    private static final double HIGH = 0.6;
    private static final int PORT_B = 0;
    private static final int PORT_C = 1;
    private static final int PORT_D = 2;
    private static final int FIRST_B = 8;
    private static final int FIRST_C = 14;
    private static final int FIRST_FREE = 2;
    private static final int NONE = -1;
    private static final double STEPS_A_SECOND = 60;
    private static final double PERCENT = 100;
    /** Marks of {@link #applied} for inputs. */
    private static final double OPEN = -1;
    private static final double PULLED = -2;
    private static final double UNKNOWN = -3;
    /** Most encoder counts that one step delivers; a sketch can't handle more. */
    private static final long MOST_EDGES = 4096;
    /** HC-SR04: shortest trigger, and time from its end to the start of the echo pulse. Source: measurements. */
    private static final long HC_TRIGGER = micros(10);
    private static final long HC_DELAY = micros(450);
    /** PING))): shortest trigger, and holdoff. Source: data sheet 28015. */
    private static final long PING_TRIGGER = micros(2);
    private static final long PING_DELAY = micros(750);

    private final BoardModel board;
    private final String name;
    private final DeviceContext context;
    private final PinWire[] wires;
    private final PinSignal[] signals;
    private final double[] applied;
    /** Pin with the echo of a trigger at this pin. */
    private final int[] echoPins;
    private final boolean[] hasEcho;
    private final long[] busyUntil;
    private final PinWire.Encoder[] tracks;
    private final long[] counts;
    private final long[] targets;
    /** Encoder counts of this step. */
    private final long[] steps;
    /** Cycle of the next edge. */
    private final long[] edges;
    private long edgesFrom;
    private long edgesTo;
    private double truthTime = Double.NaN;
    private CounterRandom random;
    private Atmega328p chip;

    SketchPins(BoardModel board, String name, DeviceContext context) {
        this.board = board;
        this.name = name;
        this.context = context;
        int pins = board.getPins();
        wires = new PinWire[pins];
        signals = new PinSignal[pins];
        applied = new double[pins];
        echoPins = new int[pins];
        hasEcho = new boolean[pins];
        busyUntil = new long[pins];
        tracks = new PinWire.Encoder[pins];
        counts = new long[pins];
        targets = new long[pins];
        steps = new long[pins];
        edges = new long[pins];
        for (int pin = 0; pin < pins; pin++) {
            signals[pin] = new PinSignal();
        }
    }

    private static long micros(double micros) {
        return Math.round(micros * PinSignal.CYCLES_A_MICRO);
    }

    void connect(int pin, PinWire wire) {
        wires[pin] = wire;
    }

    /** Starts with a chip, after all wires are connected. */
    void attach(Atmega328p newChip) {
        chip = newChip;
        for (int pin = 0; pin < wires.length; pin++) {
            echoPins[pin] = NONE;
            tracks[pin] = wires[pin] == null ? null : wires[pin].track();
            for (int other = 0; other < wires.length; other++) {
                if (wires[pin] != null && wires[other] != null && wires[pin].triggers(wires[other])) {
                    echoPins[pin] = other;
                    hasEcho[other] = true;
                }
            }
        }
        restart();
    }

    /** Forgets the past, as at a simulation's start. */
    void restart() {
        random = new CounterRandom(context.seed(), name);
        truthTime = Double.NaN;
        Arrays.fill(applied, UNKNOWN);
        Arrays.fill(busyUntil, 0);
        for (int pin = 0; pin < wires.length; pin++) {
            if (pin < FIRST_FREE || hasEcho[pin]) {
                setInput(pin, !hasEcho[pin], true);
            }
        }
    }

    /** Runs the chip up to a cycle, and applies its outputs. */
    void run(long end) {
        look();
        for (int pin = earliest(); pin != NONE && edges[pin] <= end; pin = earliest()) {
            chip.run(edges[pin]);
            counts[pin] += Long.signum(targets[pin] - counts[pin]);
            setInput(pin, wires[pin].isHigh(counts[pin]), true);
            plan(pin);
        }
        chip.run(end);
        apply();
    }

    /** Samples the inputs of a new step. */
    private void look() {
        double now = context.time();
        if (now == truthTime) {
            return;
        }
        boolean first = Double.isNaN(truthTime);
        truthTime = now;
        edgesFrom = chip.getCycle();
        edgesTo = Math.max(edgesFrom, Math.round(now * Atmega328p.CLOCK));
        for (int pin = FIRST_FREE; pin < wires.length; pin++) {
            if (tracks[pin] != null) {
                lookAtTrack(pin, first);
            } else if (!hasEcho[pin]) {
                double volts = wires[pin] == null ? Double.NaN : wires[pin].volts();
                boolean driven = !Double.isNaN(volts);
                setInput(pin, (driven ? volts : floating(pin)) >= HIGH * BoardModel.VOLTS, driven);
            }
        }
    }

    private void lookAtTrack(int pin, boolean first) {
        targets[pin] = tracks[pin].counts();
        long change = targets[pin] - counts[pin];
        if (first) {
            counts[pin] = targets[pin];
        } else if (Math.abs(change) > MOST_EDGES) {
            counts[pin] = targets[pin] - Long.signum(change) * MOST_EDGES;
        }
        steps[pin] = Math.abs(targets[pin] - counts[pin]);
        setInput(pin, wires[pin].isHigh(counts[pin]), true);
        plan(pin);
    }

    private double floating(int pin) {
        return BoardModel.VOLTS * random.uniform(Math.round(context.time() * STEPS_A_SECOND), pin, 0);
    }

    /** Spreads the counts of a step evenly over its time. */
    private void plan(int pin) {
        long left = Math.abs(targets[pin] - counts[pin]);
        edges[pin] = left == 0 ? Long.MAX_VALUE
            : edgesFrom + (edgesTo - edgesFrom) * (2 * (steps[pin] - left) + 1) / (2 * steps[pin]);
    }

    /** Returns the track with the next edge; {@link #NONE} without edges. */
    private int earliest() {
        int found = NONE;
        for (int pin = FIRST_FREE; pin < wires.length; pin++) {
            if (tracks[pin] != null && edges[pin] < (found == NONE ? Long.MAX_VALUE : edges[found])) {
                found = pin;
            }
        }
        return found;
    }

    private void setInput(int pin, boolean high, boolean driven) {
        chip.setInput(port(pin), bit(pin), high, driven);
    }

    private static int port(int pin) {
        return pin < FIRST_B ? PORT_D : pin < FIRST_C ? PORT_B : PORT_C;
    }

    private static int bit(int pin) {
        return pin < FIRST_B ? pin : pin < FIRST_C ? pin - FIRST_B : pin - FIRST_C;
    }

    /** The chip has changed an output. */
    void output(int port, int bit, Drive drive, long cycle) {
        int pin = bit + (port == PORT_D ? 0 : port == PORT_B ? FIRST_B : FIRST_C);
        if (pin >= wires.length || port == PORT_B && bit >= FIRST_C - FIRST_B) {
            return;
        }
        long width = signals[pin].set(drive, cycle);
        int echo = echoPins[pin];
        if (echo != NONE && cycle >= busyUntil[pin] && width >= (echo == pin ? PING_TRIGGER : HC_TRIGGER)) {
            long start = cycle + (echo == pin ? PING_DELAY : HC_DELAY);
            busyUntil[pin] = start + Math.round(wires[pin].echo(wires[echo]) * Atmega328p.CLOCK);
            chip.setInputAt(start, port(echo), bit(echo), true);
            chip.setInputAt(busyUntil[pin], port(echo), bit(echo), false);
        }
    }

    /** Gives the components the outputs that have changed. */
    void apply() {
        for (int pin = 0; pin < wires.length; pin++) {
            if (wires[pin] == null) {
                continue;
            }
            PinSignal signal = signals[pin];
            double level = signal.level(chip.getCycle());
            boolean input = Double.isNaN(level);
            double now = !input ? level : signal.drive() == Drive.PULLUP ? PULLED : OPEN;
            if (now != applied[pin] && input) {
                wires[pin].pull(now == PULLED);
            } else if (now != applied[pin]) {
                wires[pin].drive(level);
            }
            applied[pin] = now;
            int pulse = signal.takePulse();
            if (pulse > 0) {
                wires[pin].pulse(pulse);
            }
        }
    }

    /** Voltage at an analog channel, V. */
    double volts(int channel) {
        int pin = board.getFirstAnalog() + channel;
        if (pin >= wires.length) {
            return 0;
        }
        switch (signals[pin].drive()) {
            case HIGH:
                return BoardModel.VOLTS;
            case LOW:
                return 0;
            default:
                double volts = wires[pin] == null ? Double.NaN : wires[pin].volts();
                return !Double.isNaN(volts) ? volts
                    : signals[pin].drive() == Drive.PULLUP ? BoardModel.VOLTS : floating(pin);
        }
    }

    /** State of the connected pins, as text for users. */
    List<PinState> states() {
        List<PinState> states = new ArrayList<>();
        for (int pin = 0; pin < wires.length; pin++) {
            if (wires[pin] != null) {
                states.add(state(pin));
            }
        }
        return states;
    }

    private PinState state(int pin) {
        PinSignal signal = signals[pin];
        String mode;
        String value;
        if (signal.drive() == Drive.FLOATING || signal.drive() == Drive.PULLUP) {
            boolean up = signal.drive() == Drive.PULLUP;
            double volts = hasEcho[pin] ? 0 : wires[pin].volts();
            mode = up ? "pullup" : "input";
            value = Double.isNaN(volts) && !up ? "floats"
                : String.format(Locale.ROOT, "%.2f V", Double.isNaN(volts) ? BoardModel.VOLTS : volts);
        } else if (wires[pin] instanceof ServoWire && signal.lastPulse() > 0) {
            mode = "servo";
            value = signal.lastPulse() + " us";
        } else if (signal.isPwm(chip.getCycle())) {
            mode = "pwm";
            value = Math.round(PERCENT * signal.level(chip.getCycle())) + " %";
        } else {
            mode = "output";
            value = signal.drive() == Drive.HIGH ? "high" : "low";
        }
        return new PinState(board.nameOf(pin), wires[pin].describe(), mode, value);
    }
}
