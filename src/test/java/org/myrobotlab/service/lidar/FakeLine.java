// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.Bytes;
import org.myrobotlab.service.lidar.requests.DeviceLine;
import org.myrobotlab.service.lidar.requests.DriverEvents;

/** A port without a device, and the events of a driver. */
final class FakeLine implements DeviceLine, DriverEvents {
    final List<String> sent = new ArrayList<>();
    final List<String> errors = new ArrayList<>();
    final List<Integer> found = new ArrayList<>();
    final List<String> infos = new ArrayList<>();
    int baud;
    private double now;

    FakeLine(int baud) {
        this.baud = baud;
    }

    /** Passes time. */
    void pass(double seconds, Runnable tick) {
        for (double end = now + seconds; now < end; now += 0.01) {
            tick.run();
        }
    }

    void clear() {
        sent.clear();
        errors.clear();
        found.clear();
        infos.clear();
    }

    @Override
    public void write(byte[] bytes) {
        sent.add(Bytes.hex(bytes));
    }

    @Override
    public void setBaud(int newBaud) {
        baud = newBaud;
    }

    @Override
    public int getBaud() {
        return baud;
    }

    @Override
    public double now() {
        return now;
    }

    @Override
    public void baud(int rate) {
        found.add(rate);
    }

    @Override
    public void error(String message) {
        errors.add(message);
    }

    @Override
    public void info(String message) {
        infos.add(message);
    }
}
