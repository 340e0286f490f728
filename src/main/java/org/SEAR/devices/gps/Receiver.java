// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.nio.charset.StandardCharsets;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.SerialDevice;
import org.SEAR.sensors.GpsFix;

/** Common part of all receivers: schedule of fixes, time to first fix, and changes of baud rate. */
abstract class Receiver implements SerialDevice {
    static final double MILLIS = 1000;

    private final GpsModel model;
    private final DeviceContext context;
    private final long timeToFix;
    private int period;
    private long nextFix;
    private long fixNumber;
    private long firstFix;
    private long startedAt;
    private boolean greeted;
    private int baud;
    private int nextBaud;
    private double switchAt;
    private double latency;

    /** @param timeToFix seconds without a fix after power-on */
    Receiver(GpsModel model, double timeToFix, DeviceContext context) {
        this.model = model;
        this.timeToFix = Math.round(timeToFix * MILLIS);
        this.context = context;
    }

    /** @param seconds between a fix and the start of its output; default 0 */
    final Receiver withLatency(double seconds) {
        latency = seconds;
        return this;
    }

    /**
     * Converts a rate in Hz to a fix interval in milliseconds.
     *
     * @throws IllegalArgumentException if the model doesn't support it
     */
    static int period(GpsModel model, double rate) {
        int millis = (int) Math.round(MILLIS / rate);
        if (millis < model.getShortestPeriod() || millis > PmtkCommands.MAX_PERIOD) {
            throw new IllegalArgumentException("GPS rate is " + rate + " Hz, legal for an " + model + ": 0.1 to "
                + MILLIS / model.getShortestPeriod());
        }
        return millis;
    }

    /** Restores the factory settings. */
    abstract void deliver();

    /** Restores the state of power-on; calls {@link #begin}. */
    abstract void boot();

    /**
     * Output of a fix.
     *
     * @param fix null for none
     * @param millis UTC, milliseconds since 1970
     * @param number of the fix, counted from power-on
     */
    abstract byte[] output(GpsFix fix, long millis, long number);

    /** Receives a complete byte. */
    abstract void take(int value, double time);

    /** Discards an incomplete command. */
    abstract void forgetInput();

    /** Sets baud rate and fix interval, milliseconds, at a start. */
    final void begin(int newBaud, int newPeriod) {
        baud = newBaud;
        nextBaud = 0;
        period = newPeriod;
        fixNumber = 0;
        forgetInput();
    }

    @Override
    public final void reset() {
        deliver();
        boot();
        nextFix = period;
        firstFix = timeToFix;
        startedAt = 0;
        greeted = false;
    }

    @Override
    public final void powerOff() {
        nextBaud = 0;
    }

    @Override
    public final void powerOn(double time) {
        boot();
        greeted = true;
        restart(true, time);
        nextFix = nextFixAfter(time);
    }

    @Override
    public final int getBaud() {
        return baud;
    }

    @Override
    public final void receive(int value, double time) {
        advance(time);
        take(value, time);
    }

    @Override
    public final void receiveGarbage(double time) {
        advance(time);
        forgetInput();
    }

    @Override
    public final void advance(double time) {
        if (!greeted) {
            greeted = true;
            send(model.getGreeting(), 0);
        }
        while (nextFix / MILLIS <= time) {
            switchBaud(nextFix / MILLIS);
            fix(nextFix);
            nextFix += period;
        }
        switchBaud(time);
    }

    private void switchBaud(double time) {
        if (nextBaud != 0 && time >= switchAt) {
            baud = nextBaud;
            nextBaud = 0;
            forgetInput();
        }
    }

    /** Sends the output of a fix; skips the fix while earlier output is still on the line. */
    private void fix(long millis) {
        double time = millis / MILLIS;
        if (context.lineFreeAt() > time + latency) {
            return;
        }
        byte[] bytes = output(fixAt(millis), context.epochMillis() + millis, fixNumber);
        fixNumber++;
        if (bytes.length > 0) {
            context.send(bytes, time + latency);
        }
    }

    /** Returns the fix at a simulated time in milliseconds; null without a valid one. */
    final GpsFix fixAt(long millis) {
        GpsFix fix = millis >= firstFix ? (GpsFix) context.read(context.sensor()) : null;
        return fix != null && fix.isValid() ? fix : null;
    }

    final void send(String text, double time) {
        send(text.getBytes(StandardCharsets.US_ASCII), time);
    }

    final void send(byte[] bytes, double time) {
        context.send(bytes, time);
    }

    final void understood() {
        context.understood();
    }

    /** Changes the baud rate when all output has left the line. */
    final void changeBaud(int newBaud, double time) {
        nextBaud = newBaud;
        switchAt = Math.max(time, context.lineFreeAt());
        switchBaud(time);
    }

    final int getPeriod() {
        return period;
    }

    /** Sets the fix interval, milliseconds; fixes are at its multiples. */
    final void setPeriod(int millis, double time) {
        period = millis;
        nextFix = nextFixAfter(time);
    }

    private long nextFixAfter(double time) {
        return (long) Math.floor(time * MILLIS / period) * period + period;
    }

    /** Restarts the receiver and sends its greeting; a cold start takes the time to first fix. */
    final void restart(boolean cold, double time) {
        refresh(cold, time);
        startedAt = Math.round(time * MILLIS);
        send(model.getGreeting(), time);
    }

    /** Restarts the satellite search; a cold one takes the time to first fix. */
    final void refresh(boolean cold, double time) {
        firstFix = cold ? Math.round(time * MILLIS) + timeToFix : 0;
    }

    final GpsModel getModel() {
        return model;
    }

    /** UTC of a simulated time, milliseconds since 1970. */
    final long utc(double time) {
        return context.epochMillis() + Math.round(time * MILLIS);
    }

    /** Milliseconds from the last start to a UTC. */
    final long sinceStart(long utc) {
        return utc - context.epochMillis() - startedAt;
    }
}
