// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import java.util.Random;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.Slow;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.solid.RayRound;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** LIDAR and distance sensors compared with ray marching in the same world. */
@Category(Slow.class)
public class BeamSensorsTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static final double MILLIMETRE = 0.001;
    private static final int WORLDS = 1000;
    private static final int OWNER = 0;

    private static LIDAR lidar(double spread, double resolution, double range) {
        LIDAR parameters = new LIDAR("lidar");
        parameters.setSpread(spread);
        parameters.setResolution(resolution);
        parameters.setRange(range);
        return parameters;
    }

    private static Distance single(double range) {
        return new Distance("laser", Collections.singletonList(new BeamCone(0, range, "#ff0000", 1, 0, 0)));
    }

    private static ScriptedTruth truth(BeamScene scene) {
        ScriptedTruth truth = new ScriptedTruth();
        truth.scene = scene;
        return truth;
    }

    /** Makes a long box across the view, its near face 2 m ahead (+Z). */
    private static BeamScene wall(int owner) {
        BeamScene scene = new BeamScene();
        int wall = scene.addBox(10, 1, 0.5, owner);
        scene.setPose(wall, 0, 0, 2.5, 0, 0, 0, 1);
        scene.commit();
        return scene;
    }

    @Test
    public void lidarRangesAreRightInAThousandMovingWorlds() {
        long seed = 561;
        Random random = new Random(seed);
        for (int i = 0; i < WORLDS; i++) {
            MarchedWorld world = MarchedWorld.random(random, 6, OWNER);
            LIDAR parameters = lidar(new double[] {90, 180, 300, 360}[i % 4], 30, 8);
            parameters.move(random.nextDouble(), random.nextDouble(), random.nextDouble());
            parameters.rotate(random.nextInt(360), random.nextInt(360), random.nextInt(360));
            LidarSensor sensor = new LidarSensor(parameters, 1);
            ScriptedTruth truth = truth(world.scene);
            for (int move = 0; move < 2; move++) {
                world.scatter(random, 6);
                truth.body = MarchedWorld.pose(random, 4);
                truth.step++;
                LidarScan scan = sensor.read(truth);
                Pose pose = truth.body.times(sensor.getMount());
                for (int beam = 0; beam < scan.size(); beam++) {
                    double angle = Math.toRadians(scan.angle(beam));
                    double expected = world.march(pose.transform(0, 0, 0),
                        pose.rotate(Math.sin(angle), 0, Math.cos(angle)), 8, OWNER);
                    assertEquals("seed " + seed + ", world " + i + ", beam " + beam, expected, scan.range(beam),
                        MILLIMETRE);
                }
            }
        }
    }

    @Test
    public void distanceMeetsTheNearestOfAllLinesInAThousandWorlds() {
        long seed = 5621;
        Random random = new Random(seed);
        for (int i = 0; i < WORLDS; i++) {
            MarchedWorld world = MarchedWorld.random(random, 4, OWNER);
            world.scatter(random, 6);
            Distance parameters = new Distance(
                "ping", Arrays.asList(new BeamCone(40, 1 + random.nextDouble(), "#ff8800", 5, 0, 0),
                new BeamCone(10, 2 + random.nextDouble(), "#ff0000", 4, 0, 0),
                    new BeamCone(5, 1.5, "#00ff00", 3, 50, 20)));
            parameters.move(random.nextDouble(), random.nextDouble(), random.nextDouble());
            parameters.rotate(random.nextInt(360), random.nextInt(360), random.nextInt(360));
            DistanceSensor sensor = new DistanceSensor(parameters, 1);
            ScriptedTruth truth = truth(world.scene);
            truth.body = MarchedWorld.pose(random, 4);
            DistanceReading reading = sensor.read(truth);
            assertEquals("seed " + seed + ", world " + i,
                nearest(world, reading.getPattern(), truth.body.times(sensor.getMount())),
                reading.getDistance(), MILLIMETRE);
        }
    }

    private static double nearest(MarchedWorld world, BeamPattern pattern, Pose pose) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int line = 0; line < pattern.size(); line++) {
            double[] direction = pose.rotate(pattern.getX(line), pattern.getY(line), pattern.getZ(line));
            nearest = Math.min(nearest, world.march(pose.transform(0, 0, 0), direction, pattern.getRange(line), OWNER));
        }
        return nearest;
    }

    @Test
    public void aGrazingBeamMeetsOrMissesByMicrometres() {
        double micrometre = 1e-6;
        BeamScene scene = new BeamScene();
        int box = scene.addBox(1, 1, 1, BeamScene.WORLD);
        int pole = scene.addSolid(RayRound.cylinder(0.5, 1), BeamScene.WORLD);
        scene.setPose(box, 0, 0, 5, 0, 0, 0, 1);
        scene.setPose(pole, 20, 0, 5, 0, 0, 0, 1);
        scene.commit();
        DistanceSensor sensor = new DistanceSensor(single(10), 1);
        ScriptedTruth truth = truth(scene);
        double[][] cases = {{1 - micrometre, 4}, {1 + micrometre, Double.POSITIVE_INFINITY},
            {19.5 - micrometre, Double.POSITIVE_INFINITY},
            {19.5 + micrometre, 5 - Math.sqrt(0.25 - (0.5 - micrometre) * (0.5 - micrometre))}};
        for (double[] each : cases) {
            truth.at(each[0], 0, 0, 0, 0, 0).step++;
            assertEquals("x = " + each[0], each[1], sensor.read(truth).getDistance(), MILLIMETRE);
        }
    }

    @Test
    public void fromInsideItIsTheWayOut() {
        BeamScene scene = new BeamScene();
        scene.setPose(scene.addBox(1, 1, 2, BeamScene.WORLD), 0, 0, 0, 0, 0, 0, 1);
        scene.commit();
        LidarScan scan = new LidarSensor(lidar(180, 90, 8), 1).read(truth(scene));
        assertArrayEquals(new double[] {1, 2, 1}, scan.ranges(), 1e-9);
        assertEquals(2, new DistanceSensor(single(10), 1).read(truth(scene)).getDistance(), 1e-9);
    }

    @Test
    public void aScanGoesFromRightToLeft() {
        BeamScene scene = new BeamScene();
        scene.setPose(scene.addBox(0.5, 1, 0.5, BeamScene.WORLD), -3.5, 0, 0, 0, 0, 0, 1);
        scene.setPose(scene.addBox(0.5, 1, 0.5, BeamScene.WORLD), 5.5, 0, 0, 0, 0, 0, 1);
        scene.commit();
        LidarScan scan = new LidarSensor(lidar(180, 0.5, 8), 1).read(truth(scene));
        assertEquals(361, scan.size());
        assertEquals("3 m to the right", 3, scan.range(0), 1e-9);
        assertEquals("5 m to the left", 5, scan.range(360), 1e-9);
        assertEquals("nothing ahead", Double.POSITIVE_INFINITY, scan.range(180), 0);
        assertEquals(-90, scan.angle(0), 0);
        assertEquals(90, scan.angle(360), 0);
    }

    @Test
    public void anyFanCanBeAskedForAtTheSameStep() {
        LidarSensor sensor = new LidarSensor(lidar(180, 1, 8), 1);
        ScriptedTruth truth = truth(wall(BeamScene.WORLD));
        assertEquals(181, sensor.read(truth).size());
        assertEquals(101, sensor.scan(truth, 100, 1).size());
        assertEquals(401, sensor.scan(truth, 100, 0.25).size());
        assertEquals(361, sensor.scan(truth, 360, 1).size());
        assertEquals(2, sensor.scan(truth, 100, 0.25).range(200), 1e-9);
        assertEquals(2 / Math.cos(Math.toRadians(50)), sensor.scan(truth, 100, 0.25).range(0), 1e-9);
        double[][] illegal = {{0, 1}, {361, 1}, {90, 0}, {90, 91}, {Double.NaN, 1}};
        for (double[] fan : illegal) {
            assertThrows(IllegalArgumentException.class, () -> sensor.scan(truth, fan[0], fan[1]));
        }
    }

    /**
     * Without the doubled end a full circle has the same beams except the last. Other fans, and devices, do not change.
     */
    @Test
    public void aFullCircleWithoutTheDoubledEnd() {
        ScriptedTruth truth = truth(wall(BeamScene.WORLD));
        for (double[] fan : new double[][] {{360, 1}, {360, 0.25}, {360, 7}, {180, 1}}) {
            LIDAR parameters = lidar(fan[0], fan[1], 8);
            double[] closed = new LidarSensor(parameters, 1).read(truth).ranges();
            parameters.setClosed(false);
            LidarSensor sensor = new LidarSensor(parameters, 1);
            LidarScan open = sensor.read(truth);
            boolean doubled = fan[0] == 360 && fan[1] != 7;
            assertEquals(doubled ? closed.length - 1 : closed.length, open.size());
            assertArrayEquals(Arrays.copyOf(closed, open.size()), open.ranges(), 0);
            assertEquals(-fan[0] / 2, open.angle(0), 0);
            assertEquals(361, sensor.scan(truth, 360, 1).size());
            parameters.setScanTime(0.1);
            assertEquals("measured one after another", open.size(), new LidarSensor(parameters, 1).read(truth).size());
        }
    }

    @Test
    public void theOwnRobotIsInvisibleUnlessAskedFor() {
        ScriptedTruth own = truth(wall(OWNER));
        assertFalse(new DistanceSensor(single(10), 1).read(own).isReturn());
        assertEquals(Double.POSITIVE_INFINITY, new LidarSensor(lidar(90, 90, 8), 1).read(own).range(0), 0);
        assertTrue(new DistanceSensor(single(10), 1).read(truth(wall(OWNER + 1))).isReturn());
        Distance seeing = single(10);
        seeing.setSeesOwnRobot(true);
        assertEquals(2, new DistanceSensor(seeing, 1).read(own).getDistance(), 1e-9);
        LIDAR fan = lidar(90, 45, 8);
        fan.setSeesOwnRobot(true);
        assertEquals(2, new LidarSensor(fan, 1).read(own).range(1), 1e-9);
    }

    @Test
    public void aReadingNamesTheObjectAndThePointHit() {
        ScriptedTruth truth = truth(wall(BeamScene.WORLD));
        Distance parameters = new Distance(
            "ping", Arrays.asList(new BeamCone(20, 3, "#00ff00", 4, 0, 0), new BeamCone(0, 5, "#ff0000", 1, 0, 0)));
        parameters.move(0, 0, 0.5);
        DistanceReading reading = new DistanceSensor(parameters, 1).read(truth);
        assertEquals(1.5, reading.getDistance(), 1e-9);
        assertEquals(4, reading.getLine());
        assertEquals(0xff0000, reading.getPattern().getColor(reading.getLine()));
        assertArrayEquals(new double[] {0, 0, 2}, reading.getHitPoint(), 1e-9);
        assertEquals("shape 0", reading.getHitObject());
        truth.at(0, 0, -4, 0, 0, 0).step++;
        DistanceReading none = new DistanceSensor(parameters, 1).read(truth);
        assertFalse(none.isReturn());
        assertNull(none.getHitPoint());
        assertNull(none.getHitObject());
        assertEquals("scripts get the range", 5, none.getDistanceOrRange(), 0);
    }

    @Test
    public void belowTheMinimumRangeItReturnsTheMinimum() {
        ScriptedTruth truth = truth(wall(BeamScene.WORLD)).at(0, 0, 1.9, 0, 0, 0);
        assertEquals("LV-EZ1: 6 inches", 0.1524, new DistanceSensor(new Distance("ez", "LV-EZ1"), 1).read(truth)
            .getDistance(), 1e-12);
        assertEquals(0.1, new DistanceSensor(new Distance("ping", "PING)))"), 1).read(truth).getDistance(), 1e-9);
    }

    @Test
    public void infraredAnswersTheDataSheetsVoltages() {
        double[][] curve = {{0.02, 1.17}, {0.06, 3.15}, {0.1, 2.31}, {0.2, 1.31}, {0.4, 0.74}, {0.8, 0.40}};
        DistanceSensor sensor = new DistanceSensor(new Distance("sharp", "GP2Y0A21"), 1);
        ScriptedTruth truth = truth(wall(BeamScene.WORLD));
        for (double[] point : curve) {
            truth.at(0, 0, 2 - point[0], 0, 0, 0).step++;
            assertEquals(point[1], sensor.read(truth).volts(), 0.001);
            assertEquals(Math.max(0.1, point[0]), sensor.read(truth).getDistance(), 1e-9);
        }
        truth.at(0, 0, 2 - 1 / ((1 / 0.2 + 1 / 0.25) / 2), 0, 0, 0).step++;
        assertEquals("half way in 1/distance, between 20 and 25 cm", (1.31 + 1.09) / 2, sensor.read(truth)
            .volts(), 0.001);
        truth.at(0, 0, 0, 0, 0, 0).step++;
        assertEquals("nothing there: that of the farthest distance", 0.40, sensor.read(truth).volts(), 0.001);
        assertTrue(Double.isNaN(new DistanceSensor(single(5), 1).read(truth).volts()));
    }

    @Test
    public void linesLieOnTheirCones() {
        BeamPattern pattern = BeamPattern.of(
            Arrays.asList(new BeamCone(30, 2, "#112233", 8, 0, 0), new BeamCone(10, 1, "#445566", 4, 60, -15)));
        assertEquals(12, pattern.size());
        assertEquals(2, pattern.getMaxRange(), 0);
        for (int line = 0; line < 8; line++) {
            assertEquals(Math.cos(Math.toRadians(30)), pattern.getZ(line), 1e-12);
        }
        assertEquals("the first line is the left rim", Math.sin(Math.toRadians(30)), pattern.getX(0), 1e-12);
        assertEquals("then counter-clockwise from behind: up", Math.sin(Math.toRadians(30)), pattern.getY(2), 1e-12);
        double yaw = Math.toRadians(60);
        double pitch = Math.toRadians(-15);
        for (int line = 8; line < 12; line++) {
            double along = pattern.getX(line) * Math.sin(yaw) * Math.cos(pitch) + pattern.getY(line) * Math.sin(pitch)
                + pattern.getZ(line) * Math.cos(yaw) * Math.cos(pitch);
            assertEquals(Math.cos(Math.toRadians(10)), along, 1e-12);
            assertEquals(0x445566, pattern.getColor(line));
        }
    }

    @Test
    public void errorsAreClampedAndNoReturnStaysNoReturn() {
        Distance parameters = single(2.005);
        parameters.setNoise(new Noise().setWhite(0.5));
        LIDAR fan = lidar(180, 1, 2.5);
        fan.setNoise(new Noise().setWhite(2).setDropout(0.1));
        DistanceSensor sensor = new DistanceSensor(parameters, 1);
        LidarSensor lidar = new LidarSensor(fan, 1);
        LidarScan exact = new LidarSensor(lidar(180, 1, 2.5), 1).read(truth(wall(BeamScene.WORLD)));
        ScriptedTruth truth = truth(wall(BeamScene.WORLD));
        int lost = 0;
        int seen = 0;
        for (int i = 0; i < 200; i++) {
            truth.step++;
            assertTrue(sensor.read(truth).getDistance() >= 0 && sensor.read(truth).getDistance() <= 2.005);
            for (int beam = 0; beam < exact.size(); beam++) {
                double range = lidar.read(truth).range(beam);
                boolean there = exact.range(beam) != Double.POSITIVE_INFINITY;
                assertTrue(range == Double.POSITIVE_INFINITY || there && range >= 0 && range <= 2.5);
                seen += there ? 1 : 0;
                lost += there && range == Double.POSITIVE_INFINITY ? 1 : 0;
            }
        }
        assertEquals(0.1, lost / (double) seen, 0.02);
        parameters.setNoise(new Noise().setDropout(1));
        assertFalse(new DistanceSensor(parameters, 1).read(truth).isReturn());
    }

    @Test
    public void anotherFanHasTheSameErrors() {
        LIDAR fan = lidar(180, 1, 8);
        fan.setNoise(new Noise().setWhite(0.1));
        LidarSensor sensor = new LidarSensor(fan, 1);
        ScriptedTruth truth = truth(wall(BeamScene.WORLD));
        assertArrayEquals(sensor.read(truth).ranges(), sensor.scan(truth, 180, 1).ranges(), 0);
    }
}
