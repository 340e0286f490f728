// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.ColorSensor;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.LineSensor;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.Odometer;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.project.ProjectRule;
import org.SEAR.raycast.BeamScene;
import org.junit.Rule;
import org.junit.Test;

/** The same seed gives the same bytes, independently of readers and other sensors. A reset is a fresh start. */
public class SensorIndependenceTest {
    private static final int STEPS = 120;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static List<SensorObject> objects() {
        List<SensorObject> objects = new ArrayList<>(
            Arrays.asList(new Distance("ping", "ultrasonic"), new LIDAR("lidar"),
            new GPS("gps", 35, 200, -80), new Compass("compass", true), new Accelerometer("accel", 12),
            new Gyroscope("gyro", 7),
            new Odometer("odometer"), new IMU("imu"), new LineSensor("line"), new ColorSensor("color"),
            new Bumper("bumper"), camera("eye", Camera.COLOR), camera("kinect", Camera.DEPTH),
                camera("heat", Camera.INFRARED)));
        objects.forEach(object -> object.setNoise(new Noise(0.01, 0.02, 0.03, 0.0005, 0.1)));
        return objects;
    }

    /** Makes a camera whose pictures fall between two readings, so that they are rendered from past states. */
    private static Camera camera(String name, String kind) {
        Camera camera = new Camera(name);
        camera.setKind(kind);
        camera.setSize(12, 9);
        camera.setRate(8.3);
        camera.setShotNoise(1000, 3);
        camera.setDepthNoise(0.01);
        camera.setNetd(0.1);
        return camera;
    }

    private static List<Sensor<?>> sensors(List<SensorObject> objects, long seed) {
        List<Sensor<?>> sensors = new ArrayList<>();
        objects.forEach(object -> sensors.add(SensorTypes.load().create(object, seed)));
        return sensors;
    }

    private static String text(Object reading) {
        if (reading instanceof LidarScan) {
            return Arrays.toString(((LidarScan) reading).ranges());
        }
        if (reading instanceof CameraImage) {
            return ((CameraImage) reading).getTime() + " " + Arrays.hashCode(((CameraImage) reading).png());
        }
        return String.valueOf(reading);
    }

    /**
     * Returns all readings of a drive by sensor name.
     * @param every number of steps between two readings
     */
    private static Map<String, String> run(List<Sensor<?>> sensors, int every) {
        ScriptedTruth truth = new ScriptedTruth();
        truth.earth = new Earth(new GeoOrigin(35, 200, -80), MagneticModel.standard());
        truth.scene = new BeamScene();
        truth.scene.setPose(truth.scene.addBox(8, 1, 0.5, BeamScene.WORLD), 0, 0, 2.5, 0, 0, 0, 1);
        truth.scene.commit();
        Map<String, StringBuilder> readings = new LinkedHashMap<>();
        for (int i = 0; i < STEPS; i++) {
            truth.path += 0.005;
            truth.at(0, 0, 0.005 * i, 0, 0.5 * i, 0).moving(0, 0, 0.3 + 0.01 * Math.sin(i)).turning(0, 0.5, 0);
            truth.advance(sensors.toArray(new Sensor<?>[0]));
            for (Sensor<?> sensor : sensors) {
                if (i % every == 0) {
                    sensor.read(truth);
                }
                if (i % 6 == 5) {
                    readings.computeIfAbsent(sensor.getName(), name -> new StringBuilder())
                        .append(text(sensor.read(truth))).append('\n');
                }
            }
        }
        Map<String, String> result = new LinkedHashMap<>();
        readings.forEach((name, all) -> result.put(name, all.toString()));
        return result;
    }

    @Test
    public void theSameSeedGivesTheSameBytesAndAnotherSeedOthers() {
        Map<String, String> first = run(sensors(objects(), 1), 1);
        assertEquals(first, run(sensors(objects(), 1), 1));
        Map<String, String> other = run(sensors(objects(), 2), 1);
        assertEquals(14, other.size());
        other.forEach((name, readings) -> assertNotEquals(name, first.get(name), readings));
    }

    @Test
    public void howOftenAndInWhichOrderOneReadsDoesNotMatter() {
        Map<String, String> first = run(sensors(objects(), 1), 1);
        assertEquals(first, run(sensors(objects(), 1), STEPS));
        List<Sensor<?>> backwards = sensors(objects(), 1);
        Collections.reverse(backwards);
        assertEquals(first, run(backwards, 7));
    }

    @Test
    public void aNewSensorAndAnothersNoiseLeaveTheRestAlone() {
        Map<String, String> first = run(sensors(objects(), 1), 1);
        List<SensorObject> more = objects();
        Compass added = new Compass("added");
        added.setNoise(new Noise(1));
        more.add(0, added);
        more.get(1).setNoise(null);
        Map<String, String> second = run(sensors(more, 1), 1);
        second.forEach((name, readings) -> {
            if (name.equals("ping")) {
                assertNotEquals("its noise is gone", first.get(name), readings);
            } else if (!name.equals("added")) {
                assertEquals(name, first.get(name), readings);
            }
        });
    }

    @Test
    public void resetIsAFreshStart() {
        List<Sensor<?>> sensors = sensors(objects(), 1);
        Map<String, String> first = run(sensors, 1);
        sensors.forEach(Sensor::reset);
        assertEquals(first, run(sensors, 1));
    }
}
