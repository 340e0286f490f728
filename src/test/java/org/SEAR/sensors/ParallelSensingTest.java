// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotSame;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.geometry.Pose;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.project.ProjectRule;
import org.SEAR.raycast.BeamScene;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** Sensors that measure in parallel return the same as one by one. */
public class ParallelSensingTest {
    private static final double SPREAD = 180;
    private static final double RESOLUTION = 0.2;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private final WorkerPool workers = new WorkerPool(3);
    private final ParallelSensing sideBySide = new ParallelSensing(workers);
    private final ScriptedTruth truth = new ScriptedTruth();
    private final List<String> asked = Collections.synchronizedList(new ArrayList<>());

    @Before
    public void anEmptyWorld() {
        truth.scene = new BeamScene();
    }

    @After
    public void close() {
        workers.close();
    }

    /** A sensor that fails with its name if its flag is set. */
    private final class Broken extends Sensor<LidarScan> {
        private final Throwable failure;
        private final int beams;

        Broken(String name, int beams, Throwable failure) {
            super(new LIDAR(name), 1, 1);
            this.failure = failure;
            this.beams = beams;
        }

        @Override
        public int beamsAside() {
            return beams;
        }

        @Override
        protected LidarScan measure(Truth of) {
            asked.add(getName());
            if (failure instanceof Error) {
                throw (Error) failure;
            }
            if (failure != null) {
                throw (RuntimeException) failure;
            }
            return new LidarScan(1, 1, 1, new double[] {getName().length(), 2});
        }
    }

    @Test
    public void aParallelFailureIsThrownToTheReader() {
        Broken first = new Broken("first", 1000, null);
        Broken second = new Broken("second", 1000, new IllegalStateException("second is broken"));
        Broken third = new Broken("third", 1000, new StackOverflowError("third is deep"));
        for (int step = 0; step < 200; step++) {
            asked.clear();
            for (Sensor<?> sensor : List.of(first, second, third)) {
                sensor.forget();
                sideBySide.read(sensor, truth);
            }
            sideBySide.measure();
            assertEquals("all have measured", 3, asked.size());
            assertEquals(2, first.read(truth).size());
            assertSame(second.failure, assertThrows(IllegalStateException.class, () -> second.read(truth)));
            assertSame(third.failure, assertThrows(StackOverflowError.class, () -> third.read(truth)));
            assertEquals("first measured once", List.of("second", "third"), asked.subList(3, 5));
        }
    }

    @Test
    public void sensorsWithoutParallelMeasurementWaitForAQuery() {
        Broken own = new Broken("own", 0, null);
        sideBySide.read(own, truth);
        sideBySide.read(new Broken("left", 2000, null), truth);
        sideBySide.read(new Broken("right", 2000, null), truth);
        sideBySide.measure();
        assertTrue(asked.toString(), asked.size() == 2 && !asked.contains("own"));
    }

    @Test
    public void anExpectedScanIsMadeAheadAndOnlyForItsStep() {
        LidarSensor[] lidars = {new LidarSensor(new LIDAR("a"), 1), new LidarSensor(new LIDAR("b"), 1)};
        double[] expected = lidars[0].scan(truth, SPREAD, RESOLUTION).ranges();
        for (LidarSensor lidar : lidars) {
            lidar.expect(1, SPREAD, RESOLUTION);
            sideBySide.scan(lidar, truth, 0.9);
        }
        assertTrue("none is due yet", !sideBySide.scanAhead());
        for (LidarSensor lidar : lidars) {
            sideBySide.scan(lidar, truth, 1);
        }
        assertTrue(sideBySide.scanAhead());
        LidarScan scan = lidars[0].scan(truth, SPREAD, RESOLUTION);
        assertSame("it is there", scan, lidars[0].scan(truth, SPREAD, RESOLUTION));
        assertEquals("another fan is not", 181, lidars[0].scan(truth, SPREAD, 1).size());
        org.junit.Assert.assertArrayEquals(expected, scan.ranges(), 0);
        lidars[0].setMount(Pose.ofDegrees(0, 0, 0, 0, 10, 0));
        assertNotSame("its servo has turned it", scan, lidars[0].scan(truth, SPREAD, RESOLUTION));
        LidarScan other = lidars[1].scan(truth, SPREAD, RESOLUTION);
        lidars[1].forgetAhead();
        assertNotSame("the world may have changed", other, lidars[1].scan(truth, SPREAD, RESOLUTION));
        for (LidarSensor lidar : lidars) {
            sideBySide.scan(lidar, truth, 2);
        }
        assertTrue("what was asked for is no longer expected", !sideBySide.scanAhead());
    }
}
