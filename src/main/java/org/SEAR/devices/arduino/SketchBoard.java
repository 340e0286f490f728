// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.List;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.PinState;
import org.SEAR.devices.SerialDevice;
import org.SEAR.devices.arduino.avr.Atmega328p;
import org.SEAR.devices.arduino.avr.Surroundings;

/**
 * An Uno that runs a compiled sketch cycle by cycle. The sketch starts when its power comes. Opening the port resets
 * the board; the boot loader then has the line for a second, loses the bytes that come, and starts the sketch. The
 * EEPROM keeps its bytes until the simulation is reset. Simulation thread.
 */
final class SketchBoard implements SerialDevice, Surroundings {
    /**
     * Largest difference of the host's rate from the rate of the receiver, for 8 data bits at double speed. Source:
     * data sheet of the ATmega328P, section 20.8.3, Rslow and Rfast.
     */
    private static final double SLOWEST = 0.96;
    private static final double FASTEST = 80.0 / 77;
    private static final byte[][] MESSAGES = new byte[256][1];

    static {
        for (int i = 0; i < MESSAGES.length; i++) {
            MESSAGES[i][0] = (byte) i;
        }
    }

    private final String title;
    private final int nominalBaud;
    private final SketchPins pins;
    private final DeviceContext context;
    private final Atmega328p chip;
    private double startsAt;

    /**
     * Creates a board whose power comes at time 0.
     *
     * @param title kind of the board and its program
     * @param nominalBaud baud rate of the line before the sketch sets one
     * @param program content of the flash
     * @param pins with all wires
     */
    SketchBoard(String title, int nominalBaud, byte[] program, SketchPins pins, DeviceContext context) {
        this.title = title;
        this.nominalBaud = nominalBaud;
        this.pins = pins;
        this.context = context;
        chip = new Atmega328p(program, this);
        pins.attach(chip);
        reset();
    }

    private static long cycle(double time) {
        return Math.round(time * Atmega328p.CLOCK);
    }

    @Override
    public int getBaud() {
        double baud = chip.getBaud();
        return baud == 0 ? nominalBaud : (int) Math.max(1, Math.round(baud));
    }

    /** Any rate matches while its UART is off. */
    @Override
    public boolean matches(int hostBaud) {
        double ratio = hostBaud / chip.getBaud();
        return chip.getBaud() == 0 || ratio >= SLOWEST && ratio <= FASTEST;
    }

    @Override
    public void reset() {
        chip.eraseEeprom();
        powerOn(0);
        context.understood();
    }

    @Override
    public void powerOff() {
        chip.powerOn();
        pins.apply();
    }

    @Override
    public void powerOn(double time) {
        startsAt = Double.NaN;
        chip.powerOn();
        chip.skipTo(cycle(time));
        pins.restart();
        pins.apply();
    }

    @Override
    public void opened(double time) {
        advance(time);
        context.clearOutput();
        context.understood();
        chip.reset();
        startsAt = time + ArduinoBoard.BOOT;
        chip.skipTo(cycle(startsAt));
        pins.apply();
    }

    @Override
    public boolean isStarting() {
        return !Double.isNaN(startsAt);
    }

    @Override
    public void receive(int value, double time) {
        advance(time);
        if (!isStarting()) {
            chip.receive(value);
        }
    }

    /** Delivers a zero byte for a framing error. */
    @Override
    public void receiveGarbage(double time) {
        receive(0, time);
    }

    @Override
    public void advance(double time) {
        if (isStarting() && time >= startsAt) {
            startsAt = Double.NaN;
        }
        pins.run(cycle(time));
    }

    @Override
    public String title() {
        return "an Arduino " + title;
    }

    @Override
    public String status() {
        return title + ": " + (isStarting() ? "starting" : "running, "
            + (chip.getBaud() == 0 ? "serial off" : getBaud() + " baud"));
    }

    @Override
    public List<PinState> pinStates() {
        return pins.states();
    }

    @Override
    public void output(int port, int bit, Drive drive, long cycle) {
        pins.output(port, bit, drive, cycle);
    }

    @Override
    public double volts(int channel, long cycle) {
        return pins.volts(channel);
    }

    @Override
    public void transmit(int usart, int value, long cycle, int cycles) {
        context.send(MESSAGES[value & 0xFF], cycle / Atmega328p.CLOCK);
    }

    @Override
    public void report(String message) {
        context.warn(message);
    }
}
