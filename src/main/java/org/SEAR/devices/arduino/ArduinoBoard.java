// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.List;
import java.util.function.Function;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.PinState;
import org.SEAR.devices.SerialDevice;

/**
 * A board with its program. Opening its port resets it, as the DTR line of a real board does. The boot loader then has
 * the line for a second and loses the bytes that come; afterwards the program starts.
 */
public final class ArduinoBoard implements SerialDevice, Firmware.Host {
    /** Time that the boot loader waits for a new program, seconds. */
    static final double BOOT = 1;
    /** Bytes that wait while the program is busy. */
    static final int BUFFER = 64;

    private final String title;
    private final int baud;
    private final Pins pins;
    private final DeviceContext context;
    private final Firmware firmware;
    private final int[] waiting = new int[BUFFER];
    private int first;
    private int count;
    private double startsAt;
    private double busyUntil;

    /**
     * Creates a board that has been on for a long time.
     *
     * @param title kind of the board and its program
     * @param maker makes its program
     */
    ArduinoBoard(String title, int baud, Pins pins, DeviceContext context, Function<Firmware.Host, Firmware> maker) {
        this.title = title;
        this.baud = baud;
        this.pins = pins;
        this.context = context;
        this.firmware = maker.apply(this);
        reset();
    }

    @Override
    public int getBaud() {
        return baud;
    }

    @Override
    public boolean answersAtOnce() {
        return firmware.answersAtOnce();
    }

    @Override
    public void reset() {
        halt();
        startsAt = Double.NaN;
        firmware.setUp(0, true);
    }

    private void halt() {
        pins.release();
        first = 0;
        count = 0;
        busyUntil = 0;
    }

    @Override
    public void powerOff() {
        halt();
    }

    @Override
    public void powerOn(double time) {
        halt();
        startsAt = time + BOOT;
    }

    @Override
    public void opened(double time) {
        context.clearOutput();
        powerOn(time);
    }

    @Override
    public void openedAtOnce(double time) {
        opened(time);
        startsAt = Double.NaN;
        firmware.setUp(time, false);
        firmware.introduce();
    }

    @Override
    public void receive(int value, double time) {
        advance(time);
        if (isStarting()) {
            return;
        }
        if (time >= busyUntil) {
            firmware.receive(value, time);
        } else if (count < BUFFER) {
            waiting[(first + count++) % BUFFER] = value;
        }
    }

    @Override
    public boolean isStarting() {
        return !Double.isNaN(startsAt);
    }

    /** Delivers a zero byte for a framing error. */
    @Override
    public void receiveGarbage(double time) {
        receive(0, time);
    }

    @Override
    public void advance(double time) {
        if (isStarting()) {
            if (time < startsAt) {
                return;
            }
            double start = startsAt;
            startsAt = Double.NaN;
            firmware.setUp(start, false);
        }
        while (count > 0 && busyUntil <= time) {
            int value = waiting[first];
            first = (first + 1) % BUFFER;
            count--;
            firmware.receive(value, Math.max(busyUntil, context.time()));
        }
        if (busyUntil <= time) {
            firmware.advance(time);
        }
    }

    @Override
    public String title() {
        return "an Arduino " + title;
    }

    @Override
    public String status() {
        return title + ": " + (isStarting() ? "starting" : firmware.status()) + ", " + baud + " baud";
    }

    @Override
    public List<PinState> pinStates() {
        return pins.states();
    }

    @Override
    public Pins pins() {
        return pins;
    }

    @Override
    public void send(byte[] bytes, double time) {
        context.send(bytes, time);
    }

    @Override
    public void understood() {
        context.understood();
    }

    @Override
    public double lineFreeAt() {
        return context.lineFreeAt();
    }

    @Override
    public void busy(double until) {
        busyUntil = Math.max(busyUntil, until);
    }

    @Override
    public void warn(String cause, String message) {
        context.warn(cause, message);
    }
}
