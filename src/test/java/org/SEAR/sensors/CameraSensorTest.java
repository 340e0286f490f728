// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotSame;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.camera.image.Blobs;
import org.SEAR.geometry.Pose;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.project.ProjectRule;
import org.SEAR.raycast.BeamScene;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Pictures of cameras: content, times and errors. */
public class CameraSensorTest {
    private static final double NEAR = 1e-6;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Makes a plate on the ground with cameras 0.3 m above it. */
    private static SEARrobot plate(SensorObject... sensors) {
        SEARrobot robot = new SEARrobot("plate");
        robot.addComponent(new Dynamics("dynamics", 4, 0, 0.05, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.4, 0.4, 0.1, 4));
        for (SensorObject sensor : sensors) {
            sensor.move(0, 0.3, 0);
            robot.addComponent(sensor);
        }
        return robot;
    }

    private static Camera camera(String name, String kind, int width, int height) {
        Camera camera = new Camera(name);
        camera.setKind(kind);
        camera.setSize(width, height);
        return camera;
    }

    private Simulation load() throws Exception {
        return Simulation.load(project.folder(), 1);
    }

    private static void steps(Simulation world, int count) {
        for (int i = 0; i < count; i++) {
            world.step();
        }
    }

    private static CameraImage image(Simulation world, String name) {
        return (CameraImage) world.read(name);
    }

    @Test
    public void depthsAreMetresAlongTheAxisAndInfiniteWhereNothingComesBack() throws Exception {
        new Floor("floor", 20, 20);
        new Box("wall", 20, 0.2, 1, 0).move(0, 0.5, 3.1);
        plate(camera("depth", Camera.DEPTH, 41, 31));
        Simulation world = load();
        steps(world, 60);
        CameraImage image = image(world, "depth");
        float[] depths = image.getValues();
        assertEquals("the wall ahead", 3, depths[15 * 41 + 20], NEAR);
        assertEquals("as far along the axis at the edge", 3, depths[15 * 41], NEAR);
        assertEquals("over the wall", Float.POSITIVE_INFINITY, depths[20], 0);
        double down = Math.tan(Math.toRadians(30)) * 30 / 41;
        assertEquals("the floor", 0.35 / down, depths[30 * 41 + 20], NEAR);
        BeamScene scene = world.getRobots().get(0).getTruth().scene();
        Pose eye = image.getPose();
        for (int i = 0; i < depths.length; i++) {
            double left = Math.tan(Math.toRadians(30)) * (40 - 2 * (i % 41)) / 41;
            double up = Math.tan(Math.toRadians(30)) * (30 - 2 * (i / 41)) / 41;
            double length = Math.sqrt(1 + left * left + up * up);
            double[] way = eye.rotate(left / length, up / length, 1 / length);
            double single = scene.cast(eye.x, eye.y, eye.z, way[0], way[1], way[2], 1e4, 0, null) / length;
            assertEquals("pixel " + i, (float) single, depths[i], Math.ulp((float) Math.min(1e4, single)));
        }
    }

    /**
     * The distance is that of the world when the picture was due, although objects moved since. Before the first
     * picture is due, it is that of the present.
     */
    @Test
    public void pointingAtAColourPixelReturnsItsDistance() throws Exception {
        new Floor("floor", 20, 20);
        Box crate = new Box("crate", 0.5, 0.5, 0.5, 1);
        crate.move(0, 0.3, 2);
        crate.setVelocity(0, 0, -1);
        plate(camera("color", Camera.COLOR, 41, 31), camera("depth", Camera.DEPTH, 41, 31));
        Simulation world = load();
        CameraSensor eye = (CameraSensor) world.getSensor("color");
        assertTrue("no picture yet", Double.isNaN(eye.depth(0)));
        for (int steps : new int[] {1, 9, 10}) {
            steps(world, steps);
            float[] depths = image(world, "depth").getValues();
            image(world, "color");
            for (int i = 0; i < depths.length; i++) {
                assertEquals("pixel " + i, depths[i], eye.depth(i), 1e-6 * Math.min(1e4, depths[i]));
            }
            image(world, "color");
            assertTrue("the crate is there", depths[15 * 41 + 20] < 2);
        }
    }

    @Test
    public void pointsAreWhereTheBeamsEnd() throws Exception {
        new Floor("floor", 20, 20);
        new Box("wall", 20, 0.2, 3, 0).move(0, 1.5, 3.1);
        Camera depth = camera("depth", Camera.DEPTH, 21, 11);
        depth.setFieldOfView(10);
        SEARrobot robot = plate(depth);
        Servo neck = new Servo("neck", 0, 0.3, 0);
        robot.addComponent(neck);
        neck.mount(depth);
        Simulation world = load();
        world.order(new ActuatorOrder(ActuatorOrder.Kind.ANGLE, "neck", 30));
        steps(world, 120);
        CameraImage image = image(world, "depth");
        float[] inWorld = image.getPoints(true);
        assertEquals(3 * 21 * 11, inWorld.length);
        for (int i = 0; i < inWorld.length; i += 3) {
            assertEquals("on the wall", 3, inWorld[i + 2], 1e-5);
        }
        float[] own = image.getPoints(false);
        int middle = 3 * (5 * 21 + 10);
        assertEquals(0, own[middle], 1e-6);
        assertEquals(0, own[middle + 1], 1e-6);
        assertEquals("30 degrees to the left", 3 / Math.cos(Math.toRadians(30)), own[middle + 2], 1e-3);
        assertTrue("the left edge is to the left", own[0] > 0 && own[1] > 0);
        assertEquals("and so it is in the world", 3 * Math.tan(Math.toRadians(30)), inWorld[middle], 1e-3);
    }

    @Test
    public void infraredSeesTemperaturesAndAmbient() throws Exception {
        new Floor("floor", 20, 20);
        Box warm = new Box("warm", 0.5, 0.5, 0.5, 0);
        warm.move(0, 0.5, 2);
        warm.setTemperature(36.6);
        plate(camera("heat", Camera.INFRARED, 32, 24));
        Simulation world = load();
        steps(world, 60);
        float[] heat = image(world, "heat").getValues();
        assertEquals(36.6, heat[10 * 32 + 16], 1e-5);
        assertEquals("the floor is as warm as everything", 20, heat[23 * 32 + 2], NEAR);
        assertEquals("the sky is cold", -20, heat[0], NEAR);
        assertArrayEquals(new double[] {-20, 36.6}, image(world, "heat").numbers(), 1e-5);
        assertEquals("32 x 24, -20.0 to 36.6 degC", image(world, "heat").words(""));
    }

    @Test
    public void aLineCameraIsOneRow() throws Exception {
        Box red = new Box("red", 0.4, 0.4, 0.4, 0);
        red.setColor("red");
        red.move(0.6, 0.35, 2);
        plate(camera("line", Camera.COLOR, 128, 1));
        Simulation world = load();
        steps(world, 10);
        int[] row = image(world, "line").getPixels();
        assertEquals(128, row.length);
        List<Blobs.Blob> blobs = image(world, "line").blobs(0xff0000, 3);
        assertEquals(1, blobs.size());
        assertTrue("on the left: " + blobs.get(0).x, blobs.get(0).x < 50);
        assertEquals(1, blobs.get(0).height);
    }

    @Test
    public void picturesComeAtTheRateOfTheSimulationsClock() throws Exception {
        new Box("wall", 20, 0.2, 3, 0).move(0, 1.5, 3.1);
        Camera eye = camera("eye", Camera.COLOR, 8, 6);
        eye.setRate(10);
        plate(eye);
        Simulation world = load();
        steps(world, 2);
        assertEquals("before the first one that of the moment", 2 / 60.0, image(world, "eye").getTime(), 1e-12);
        steps(world, 4);
        CameraImage first = image(world, "eye");
        assertEquals(0.1, first.getTime(), 1e-12);
        steps(world, 5);
        assertSame(first, image(world, "eye"));
        steps(world, 1);
        assertNotSame(first, image(world, "eye"));
        assertEquals(0.2, image(world, "eye").getTime(), 1e-12);
    }

    @Test
    public void aLateRenderedPictureShowsTheWorldOfItsTime() throws Exception {
        new Floor("floor", 20, 20);
        new Box("falling", 0.5, 0.5, 0.5, 1).move(0, 4, 3);
        plate(camera("eye", Camera.COLOR, 64, 48), camera("depth", Camera.DEPTH, 64, 48));
        Simulation atOnce = load();
        Simulation later = load();
        for (int picture = 1; picture <= 8; picture++) {
            steps(atOnce, 6);
            CameraImage eye = image(atOnce, "eye");
            CameraImage depth = image(atOnce, "depth");
            steps(later, picture == 1 ? 11 : 6);
            assertEquals(eye.getTime(), image(later, "eye").getTime(), 0);
            assertArrayEquals("picture " + picture, eye.getPixels(), image(later, "eye").getPixels());
            assertArrayEquals("picture " + picture, depth.getValues(), image(later, "depth").getValues(), 0);
        }
    }

    @Test
    public void severalThreadsMakeTheSameBytes() throws Exception {
        new Floor("floor", 20, 20);
        new Box("box", 0.5, 0.5, 0.5, 0).move(0.3, 0.25, 2);
        plate(camera("eye", Camera.COLOR, 320, 240));
        Simulation world = load();
        steps(world, 6);
        CameraImage image = image(world, "eye");
        org.SEAR.camera.CameraRenderer alone = new org.SEAR.camera.CameraRenderer((Camera) world.getSensor("eye")
            .getParameters());
        Truth truth = world.getRobots().get(0).getTruth();
        for (int threads : new int[] {1, 2, 4}) {
            try (WorkerPool pool = new WorkerPool(threads)) {
                alone.setWorkers(pool);
                assertArrayEquals(image.getPixels(),
                    alone.colors(new org.SEAR.camera.RenderJob(truth.sight(), truth.looks(), image.getPose(),
                        truth.owner())));
            }
        }
    }

    @Test
    public void noiseIsTheCamerasOwnAndTheSameEachRun() throws Exception {
        new Floor("floor", 20, 20);
        new Box("wall", 20, 0.2, 6, 0).move(0, 3, 4.1);
        Camera eye = camera("eye", Camera.COLOR, 80, 60);
        eye.setShotNoise(400, 5);
        Camera depth = camera("depth", Camera.DEPTH, 80, 60);
        depth.setDepthNoise(0.002);
        Camera heat = camera("heat", Camera.INFRARED, 80, 60);
        heat.setNetd(0.2);
        depth.setFieldOfView(5);
        plate(eye, depth, heat);
        Simulation world = load();
        steps(world, 30);
        assertEquals("16 times as much at 4 m", 0.032, deviation(image(world, "depth").getValues(), 4), 0.001);
        assertEquals(0.2, deviation(image(world, "heat").getValues(), 20), 0.01);
        int[] pixels = image(world, "eye").getPixels();
        Simulation again = load();
        steps(again, 30);
        assertArrayEquals(pixels, image(again, "eye").getPixels());
        steps(again, 6);
        assertFalse(Arrays.equals(pixels, image(again, "eye").getPixels()));
        again.reset();
        steps(again, 30);
        assertArrayEquals("after a reset, too", pixels, image(again, "eye").getPixels());
    }

    private static double deviation(float[] values, double mean) {
        double sum = 0;
        for (float value : values) {
            sum += (value - mean) * (value - mean);
        }
        return Math.sqrt(sum / values.length);
    }

    @Test
    public void shotNoiseIsTheRootOfTheElectrons() throws Exception {
        Camera eye = camera("eye", Camera.COLOR, 200, 100);
        eye.setShotNoise(200, 0);
        eye.setFieldOfView(1);
        plate(eye);
        new Box("wall", 20, 0.2, 6, 0).move(0, 3, 4.1);
        Simulation world = load();
        steps(world, 6);
        double sum = 0;
        double squares = 0;
        int[] pixels = image(world, "eye").getPixels();
        for (int rgb : pixels) {
            double electrons = 200 * LightSpot.linear(rgb >> 8 & 0xff);
            sum += electrons;
            squares += electrons * electrons;
        }
        double mean = sum / pixels.length;
        assertEquals(Math.sqrt(mean), Math.sqrt(squares / pixels.length - mean * mean), 0.1 * Math.sqrt(mean));
    }

    @Test
    public void aReadingsOwnErrorsAreThoseOfItsNumbers() throws Exception {
        new Floor("floor", 20, 20);
        new Box("wall", 20, 0.2, 6, 0).move(0, 3, 4.1);
        Camera depth = camera("depth", Camera.DEPTH, 30, 20);
        depth.setFieldOfView(5);
        depth.setNoise(new Noise(0, 0.5, 0, 0, 0.25));
        plate(depth);
        Simulation world = load();
        steps(world, 6);
        int lost = 0;
        for (float value : image(world, "depth").getValues()) {
            lost += value == Float.POSITIVE_INFINITY ? 1 : 0;
            assertTrue(String.valueOf(value), value == Float.POSITIVE_INFINITY || Math.abs(value - 4.5) < 1e-5);
        }
        assertEquals(150, lost, 40);
    }

    @Test
    public void pngFilesHoldColoursMillimetresAndCentikelvin() throws Exception {
        new Floor("floor", 20, 20);
        Box wall = new Box("wall", 20, 0.2, 6, 0);
        wall.move(0, 3, 4.1);
        wall.setTemperature(30);
        plate(camera("eye", Camera.COLOR, 33, 20), camera("depth", Camera.DEPTH, 33, 20),
            camera("heat", Camera.INFRARED, 33, 20));
        Simulation world = load();
        steps(world, 60);
        int[] pixels = image(world, "eye").getPixels();
        BufferedImage colors = ImageIO.read(new ByteArrayInputStream(image(world, "eye").png()));
        BufferedImage depths = ImageIO.read(new ByteArrayInputStream(image(world, "depth").png()));
        BufferedImage heats = ImageIO.read(new ByteArrayInputStream(image(world, "heat").png()));
        float[] metres = image(world, "depth").getValues();
        for (int i = 0; i < pixels.length; i++) {
            assertEquals(pixels[i], colors.getRGB(i % 33, i / 33) & 0xffffff);
            assertEquals(Math.round(1000 * metres[i]), depths.getRaster().getSample(i % 33, i / 33, 0));
        }
        assertEquals(30315, heats.getRaster().getSample(16, 5, 0));
    }

    @Test
    public void blobsAreThePiecesOfAHueTheLargestFirst() throws Exception {
        new Floor("floor", 20, 20);
        for (int i = 0; i < 3; i++) {
            Box box = new Box("box" + i, 0.2 + 0.1 * i, 0.2, 0.2 + 0.1 * i, 0);
            box.setColor(i == 1 ? "blue" : "red");
            box.move(0.8 - 0.8 * i, 0.3, 2);
        }
        plate(camera("eye", Camera.COLOR, 320, 240), camera("depth", Camera.DEPTH, 8, 8));
        Simulation world = load();
        steps(world, 60);
        List<Blobs.Blob> red = image(world, "eye").blobs(0xff0000, 8);
        assertEquals(2, red.size());
        assertTrue("the larger one is to the right", red.get(0).x > 160 && red.get(1).x < 160);
        assertTrue(red.get(0).area > 1.5 * red.get(1).area && red.get(0).area <= red.get(0).width * red.get(0).height);
        assertEquals(1, image(world, "eye").blobs(0x0000ff, 8).size());
        assertEquals(0, image(world, "eye").blobs(0x0000ff, 100_000).size());
        String message = assertThrows(IllegalStateException.class, () -> image(world, "depth").blobs(0xff0000, 8))
            .getMessage();
        assertEquals("a picture of depth has no colours; use setKind(\"color\")", message);
        assertThrows(IllegalStateException.class, () -> image(world, "eye").getPoints(true));
    }

    @Test
    public void itsOwnRobotIsSeenIfAsked() throws Exception {
        Camera blind = camera("blind", Camera.DEPTH, 5, 5);
        blind.rotate(90, 0, 0);
        Camera own = camera("own", Camera.DEPTH, 5, 5);
        own.rotate(90, 0, 0);
        own.setSeesOwnRobot(true);
        plate(blind, own);
        Simulation world = load();
        assertEquals("nothing", image(world, "blind").words("").substring(7));
        assertEquals(0.25, image(world, "own").getValues()[12], NEAR);
    }
}
