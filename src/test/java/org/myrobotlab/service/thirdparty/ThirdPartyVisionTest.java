// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.Needs;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Chessboard;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Marker;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.Slow;
import org.SEAR.geometry.Pose;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.sear.RecordingHost;
import org.myrobotlab.service.sear.readings.ScriptCameras;
import org.myrobotlab.service.sear.run.SimulationControl;

/** OpenCV measures simulated pictures: the camera by a chessboard, poses by markers. */
@Category(Slow.class)
@Needs("opencv")
public class ThirdPartyVisionTest {
    private static final double FIELD_OF_VIEW = 60;
    private static final int VIEWS = 20;
    private static final double SIZE = 0.2;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private final Programs programs = new Programs(folder);
    private SimulationControl control;
    private ScriptCameras cameras;

    @Before
    public void make() {
        Path project = folder.getRoot().toPath().resolve("SEARproject");
        System.setProperty("sear.headless", "true");
        System.setProperty("sear.project", project.toString());
        control = new SimulationControl(new RecordingHost(), () -> project);
        cameras = new ScriptCameras(control);
        control.scriptSession().open();
    }

    @After
    public void stop() {
        programs.end();
        control.stop();
        control.scriptSession().close();
        System.clearProperty("sear.project");
        System.clearProperty("sear.headless");
    }

    /** Returns the focal length, pixels. */
    private static double focalLength(int width) {
        return width / 2.0 / Math.tan(Math.toRadians(FIELD_OF_VIEW / 2));
    }

    private String save(String name) throws Exception {
        return Files.write(folder.getRoot().toPath().resolve(name + ".png"), cameras.png(name)).toString();
    }

    private List<String> python(String script, List<String> arguments) throws Exception {
        ProcessBuilder builder = WithPrograms.python(script, arguments.toArray());
        builder.environment().put("PYTHONPATH", System.getProperty("sear.opencv"));
        return programs.run(builder, new ArrayList<>());
    }

    private static double[] numbers(String line, int first) {
        String[] words = line.split(" ");
        return Arrays.stream(words, first, words.length).mapToDouble(Double::parseDouble).toArray();
    }

    /**
     * Cameras with the same lens around a chessboard, each near enough to fill much of its picture and roughly facing
     * it.
     */
    @Test
    public void twentyViewsOfAChessboardCalibrateACamera() throws Exception {
        new Floor("floor", 20, 20);
        new Chessboard("board", 10, 7, 0.03, 0, 1, 1.5);
        SEARrobot robot = new SEARrobot("stand");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.05, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.1, 0.1, 0.1, 4));
        robot.move(0, 1, 0);
        Random random = new Random(1);
        for (int i = 0; i < VIEWS; i++) {
            double distance = 0.55 + 0.015 * i;
            double x = 0.45 * distance * (2 * random.nextDouble() - 1);
            double y = 0.45 * distance * (2 * random.nextDouble() - 1);
            double yaw = Math.toDegrees(Math.atan2(-x, distance)) + 5 * (2 * random.nextDouble() - 1);
            double pitch = Math.toDegrees(Math.atan2(y, distance)) + 4 * (2 * random.nextDouble() - 1);
            Camera camera = new Camera("eye" + i, x, y, 1.5 - distance, pitch, yaw, 40 * (2 * random.nextDouble() - 1));
            camera.setSize(640, 480);
            camera.setFieldOfView(FIELD_OF_VIEW);
            camera.setLens(-0.25, 0.06, 0, 0);
            camera.setCentre(325.0, 236.0);
            robot.addComponent(camera);
        }
        control.start(false);
        control.session().pause();
        List<String> arguments = new ArrayList<>(List.of("9", "6"));
        for (int i = 0; i < VIEWS; i++) {
            arguments.add(save("eye" + i));
        }
        List<String> output = python("opencv_calibrate.py", arguments);
        assertTrue(output + ": found in nearly all", Integer.parseInt(output.get(0)) >= VIEWS - 1);
        double[] found = numbers(output.get(1), 0);
        String told = output.toString();
        assertEquals(told, 1, found[0] / focalLength(640), 0.003);
        assertEquals(told, 1, found[1] / focalLength(640), 0.003);
        assertEquals(told, 1, found[2] / 325, 0.003);
        assertEquals(told, 1, found[3] / 236, 0.003);
        assertEquals(told, 1, found[4] / -0.25, 0.02);
    }

    @Test
    public void theCodesOfMarkersAreThoseOfOpencv() throws Exception {
        Path made = folder.newFolder("codes").toPath();
        python("marker_codes.py", List.of(made.toString()));
        Path shipped = Path.of(System.getProperty("sear.root", ".")).resolve("resources/org/SEAR/files/markers");
        List<Path> files;
        try (Stream<Path> all = Files.list(made)) {
            files = all.collect(Collectors.toList());
        }
        assertEquals(5, files.size());
        for (Path file : files) {
            assertEquals(Files.readString(file), Files.readString(shipped.resolve(file.getFileName())));
        }
    }

    @Test
    public void markersAreFoundAtTheirPoses() throws Exception {
        new Floor("floor", 20, 20);
        Pose aruco = Pose.ofDegrees(0.4, 0.5, 2, 0, 35, 10);
        new Marker("aruco", "DICT_4X4_50", 7, SIZE, 0.4, 0.5, 2, 0, 35, 10);
        Pose tag = Pose.ofDegrees(-0.4, 0.4, 2, 25, -20, 0);
        new Marker("tag", "APRILTAG_36h11", 42, SIZE, -0.4, 0.4, 2, 25, -20, 0);
        SEARrobot robot = Robots.create2("rover");
        Camera camera = new Camera("eye", 0, 0.3, 0);
        camera.setSize(1280, 720);
        camera.setFieldOfView(FIELD_OF_VIEW);
        robot.addComponent(camera);
        control.start(false);
        control.session().simSleep(0.5);
        control.session().pause();
        String picture = save("eye");
        List<String> output = python("opencv_markers.py",
            List.of(picture, "" + focalLength(1280), "639.5", "359.5", "" + SIZE, "DICT_4X4_50", "APRILTAG_36h11"));
        assertEquals(output.toString(), 2, output.size());
        Pose eye = cameras.look("eye").getPose();
        assertIsThere(output.get(0), "DICT_4X4_50 7", eye, aruco);
        assertIsThere(output.get(1), "APRILTAG_36h11 42", eye, tag);
    }

    /** In OpenCV's frames the camera's x points right and y down, and a marker's z out of its front. */
    private static void assertIsThere(String line, String name, Pose eye, Pose marker) {
        assertTrue(line, line.startsWith(name + " "));
        double[] found = numbers(line, 2);
        double[] place = eye.rotateBack(marker.x - eye.x, marker.y - eye.y, marker.z - eye.z);
        double off = Math.sqrt(Math.pow(found[9] + place[0], 2) + Math.pow(found[10] + place[1], 2)
            + Math.pow(found[11] - place[2], 2));
        assertTrue(line + " is " + off + " m off " + Arrays.toString(place), off < 0.01);
        double trace = 0;
        for (int axis = 0; axis < 3; axis++) {
            double[] own = {axis == 0 ? -1 : 0, axis == 1 ? 1 : 0, axis == 2 ? -1 : 0};
            double[] world = marker.rotate(own[0], own[1], own[2]);
            double[] seen = eye.rotateBack(world[0], world[1], world[2]);
            trace += -seen[0] * found[axis] - seen[1] * found[3 + axis] + seen[2] * found[6 + axis];
        }
        double degrees = Math.toDegrees(Math.acos(Math.min(1, (trace - 1) / 2)));
        assertTrue(line + " is turned by " + degrees + " degrees", degrees < 1);
    }
}
