// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import org.SEAR.devices.arduino.avr.Atmega328p;
import org.SEAR.devices.arduino.avr.Surroundings.Drive;

/**
 * Output of one pin of a microcontroller over time: its level, and period and width of its pulses. Times are clock
 * cycles. Simulation thread.
 */
final class PinSignal {
    static final double CYCLES_A_MICRO = Atmega328p.CLOCK / 1e6;
    /** Longest period of pulses that count as PWM. Slower pulses are levels, as of a blinking light. */
    private static final long LONGEST_PWM = Math.round(Atmega328p.CLOCK / 60);
    /** Pulses that a servo follows, us, and the shortest period at which it accepts them. */
    private static final int SHORTEST_PULSE = 400;
    private static final int LONGEST_PULSE = 2600;
    private static final long SHORTEST_PERIOD = Math.round(3000 * CYCLES_A_MICRO);
    private static final long NEVER = -1;

    private Drive drive = Drive.FLOATING;
    private long rise = NEVER;
    private long fall = NEVER;
    private long period;
    private long high;
    private int pulse;
    private int lastPulse;

    Drive drive() {
        return drive;
    }

    /**
     * Sets the output at a cycle.
     *
     * @return width of the pulse that ends now, cycles; 0 if none does
     */
    long set(Drive now, long cycle) {
        boolean was = drive == Drive.HIGH;
        drive = now;
        if (now == Drive.HIGH && !was) {
            period = rise == NEVER ? 0 : cycle - rise;
            high = fall > rise ? fall - rise : 0;
            rise = cycle;
            return 0;
        }
        long width = was && now != Drive.HIGH && rise != NEVER ? cycle - rise : 0;
        if (width > 0) {
            fall = cycle;
            int micros = (int) Math.min(Integer.MAX_VALUE, Math.round(width / CYCLES_A_MICRO));
            if (micros >= SHORTEST_PULSE && micros <= LONGEST_PULSE && (period == 0 || period >= SHORTEST_PERIOD)) {
                pulse = micros;
                lastPulse = micros;
            }
        }
        if (now == Drive.FLOATING || now == Drive.PULLUP) {
            rise = NEVER;
            fall = NEVER;
            period = 0;
            lastPulse = 0;
        }
        return width;
    }

    /** Whether the pin repeats pulses fast enough for PWM. */
    boolean isPwm(long cycle) {
        return period > 0 && period <= LONGEST_PWM && cycle - Math.max(rise, fall) <= period;
    }

    /** Mean share of the supply voltage; NaN if the pin is an input. */
    double level(long cycle) {
        if (drive == Drive.FLOATING || drive == Drive.PULLUP) {
            return Double.NaN;
        }
        return isPwm(cycle) ? high / (double) period : drive == Drive.HIGH ? 1 : 0;
    }

    /** Returns the newest pulse for a servo since the last call, us; 0 if there was none. */
    int takePulse() {
        int micros = pulse;
        pulse = 0;
        return micros;
    }

    /** Newest pulse for a servo, us; 0 if there was none since the pin was an input. */
    int lastPulse() {
        return lastPulse;
    }
}
