// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntToDoubleFunction;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.LidarSource;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Truth;

/** A LIDAR whose measurements a test sets. */
public final class FakeScanner extends Sensor<LidarScan> implements LidarSource {
    /** Range in metres by beam number, from the right. */
    public IntToDoubleFunction world = beam -> Double.POSITIVE_INFINITY;
    public int scans;
    /** Times at which the device measured each beam, simulated seconds. */
    public final Map<Integer, List<Double>> times = new TreeMap<>();

    public FakeScanner() {
        super(ProjectRule.unread(() -> new LIDAR("lidar")), 0, 1);
    }

    @Override
    public LidarScan scan(Truth truth, double spread, double resolution) {
        scans++;
        double[] ranges = new double[(int) Math.round(spread / resolution) + 1];
        Arrays.setAll(ranges, world);
        return new LidarScan(spread, resolution, Double.POSITIVE_INFINITY, ranges);
    }

    @Override
    public double range(Truth truth, LidarScan scan, int beam, double time) {
        times.computeIfAbsent(beam, any -> new ArrayList<>()).add(time);
        return scan.range(beam);
    }

    @Override
    protected LidarScan measure(Truth truth) {
        return scan(truth, 180, 1);
    }
}
