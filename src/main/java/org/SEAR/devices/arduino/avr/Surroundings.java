// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

/** The circuit around a microcontroller. Ports are numbered from A = 0; times are cycles since the start. */
public interface Surroundings {
    /** A pin drives a low or a high level, floats, or has its pull-up resistor on. */
    enum Drive { LOW, HIGH, FLOATING, PULLUP }

    /** A pin has changed its output. */
    void output(int port, int bit, Drive drive, long cycle);

    /** Returns the voltage at a channel of the ADC, V. */
    double volts(int channel, long cycle);

    /** A USART begins to send a byte, which takes the given cycles with start, parity and stop bits. */
    void transmit(int usart, int value, long cycle, int cycles);

    /** Reports something that the program does and that is a fault or not simulated. Called once per cause. */
    void report(String message);
}
