// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.Bytes;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Truth;

/** A line with ten bits per byte, a scripted clock and settable hardware around one device. */
public final class FakeContext implements DeviceContext {
    /** 2026-01-01T12:00:00Z. */
    public static final long EPOCH = 1767268800000L;

    public final FakeHardware hardware = new FakeHardware();
    public final List<String> warnings = new ArrayList<>();
    private final java.util.Set<String> causes = new java.util.HashSet<>();
    public Sensor<?> sensor;
    /** Sensors of other components, by name. */
    public final java.util.Map<String, Sensor<?>> parts = new java.util.HashMap<>();
    public Reading reading;
    /** Files below assets, by path. */
    public final java.util.Map<String, byte[]> assets = new java.util.HashMap<>();
    /** Seed of the simulation. */
    public long seed = 1;
    public double now;
    /** Number of commands that the device knew. */
    public int understood;
    public long epoch = EPOCH;
    /** Start times of the bytes sent since the last {@link #take}, one per byte, seconds. */
    public final List<Double> times = new ArrayList<>();
    /** Times at which messages began to leave, as long as {@link #take} is not called. */
    public final List<Double> messages = new ArrayList<>();
    private final ByteArrayOutputStream sent = new ByteArrayOutputStream();
    private SerialDevice device;
    private double free;

    public <D extends SerialDevice> D attach(D newDevice) {
        device = newDevice;
        return newDevice;
    }

    /** Sends bytes from host to device at the device's speed. */
    public void host(int... bytes) {
        for (int value : bytes) {
            now += byteTime();
            device.receive(value & 0xFF, now);
        }
    }

    /**
     * Sends bytes from host to device.
     * @param hex for example {@code "02 00 01 00 31 15 12"}
     */
    public void host(String hex) {
        host(Bytes.ints(hex));
    }

    public void hostText(String text) {
        for (byte value : text.getBytes(StandardCharsets.US_ASCII)) {
            host(value);
        }
    }

    /** Passes time in small steps. */
    public void pass(double seconds) {
        double end = now + seconds;
        while (now < end) {
            now = Math.min(end, now + 1 / 60.0);
            device.advance(now);
        }
    }

    /** Switches power off and on and sets simulated time to 0. */
    public void restart() {
        now = 0;
        free = 0;
        device.reset();
        take();
    }

    /** Returns the bytes sent since the last call. */
    public byte[] take() {
        byte[] bytes = sent.toByteArray();
        sent.reset();
        times.clear();
        messages.clear();
        return bytes;
    }

    public String takeHex() {
        return Bytes.hex(take());
    }

    public String takeText() {
        return new String(take(), StandardCharsets.US_ASCII);
    }

    private double byteTime() {
        return 10.0 / device.getBaud();
    }

    @Override
    public void send(byte[] bytes, double time) {
        free = Math.max(free, time);
        messages.add(free);
        for (byte value : bytes) {
            times.add(free);
            free += byteTime();
        }
        sent.write(bytes, 0, bytes.length);
    }

    @Override
    public double lineFreeAt() {
        return free;
    }

    @Override
    public void clearOutput() {
        free = 0;
    }

    @Override
    public void cutOutput(double time) {
        byte[] bytes = sent.toByteArray();
        int kept = bytes.length;
        while (kept > 0 && times.get(kept - 1) >= time) {
            times.remove(--kept);
        }
        free = kept > 0 ? times.get(kept - 1) + byteTime() : time;
        sent.reset();
        sent.write(bytes, 0, kept);
    }

    @Override
    public void understood() {
        understood++;
    }

    @Override
    public RobotHardware robot() {
        return hardware;
    }

    @SuppressWarnings("unchecked")
    @Override
    public <R extends Reading> R read(Sensor<R> which) {
        return (R) reading;
    }

    @Override
    public Sensor<?> sensor() {
        return sensor;
    }

    @Override
    public Sensor<?> sensor(String part) {
        return parts.get(part);
    }

    @Override
    public byte[] asset(String path) {
        return assets.get(path);
    }

    @Override
    public Truth truth() {
        return null;
    }

    @Override
    public double time() {
        return now;
    }

    @Override
    public long epochMillis() {
        return epoch;
    }

    @Override
    public long seed() {
        return seed;
    }

    @Override
    public void warn(String cause, String message) {
        if (causes.add(cause)) {
            warnings.add(message);
        }
    }
}
