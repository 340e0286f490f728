// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.BrownLens;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.camera.Daylight;
import org.SEAR.camera.CameraRenderer;
import org.SEAR.camera.RenderJob;
import org.SEAR.files.Assets;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.sensors.Truth;
import org.SEAR.simulator.Simulation;

/**
 * Scene of a camera benchmark: a {@link Room} with a rover, or an example's world after one second. The camera is above
 * the robot, with 320 x 240 pixels and 60 degrees. It looks slightly down and turns by ten degrees per picture.
 */
final class PictureWorld {
    static final int WIDTH = 320;
    static final int HEIGHT = 240;
    /** Pictures per turn. */
    static final int TURNS = 36;
    static final double NEAR = 0.02;
    static final double FAR = 10_000;
    /** Horizontal field of view, degrees. */
    static final double FIELD_OF_VIEW = 60;
    private static final double ABOVE = 0.3;
    private static final double DOWN = 10;
    private static final int STEPS = 60;

    final Simulation simulation;
    final CameraRenderer eye;
    private final Truth truth;

    /** @param name room-N, or the name of an example */
    PictureWorld(String name) throws IOException, ProjectException {
        Path folder = Files.createTempDirectory("pictures").resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        if (name.startsWith("room")) {
            new Room(name).build();
            Robots.rover("rover");
        } else {
            Bundle.load(Path.of(System.getProperty("sear.root", "."), "examples", name + ".sear"), folder);
        }
        simulation = Simulation.load(folder, 1);
        for (int step = 0; step < STEPS; step++) {
            simulation.step();
        }
        truth = simulation.getRobots().get(0).getTruth();
        double focal = WIDTH / (2 * Math.tan(Math.toRadians(FIELD_OF_VIEW / 2)));
        eye = new CameraRenderer(WIDTH, HEIGHT,
            new BrownLens(focal, (WIDTH - 1) / 2.0, (HEIGHT - 1) / 2.0, new double[4]), NEAR, FAR);
    }

    /** Returns the camera's pose for a picture: x to its left, y up, z ahead. */
    Pose pose(int turn) {
        Pose body = truth.body();
        Pose place = new Pose(body.x, body.y + ABOVE, body.z, 0, 0, 0, 1);
        return place.times(Pose.ofDegrees(0, 0, 0, 0, 360.0 * turn / TURNS, 0))
            .times(Pose.ofDegrees(0, 0, 0, DOWN, 0, 0));
    }

    int[] colors(int turn) {
        return eye.colors(new RenderJob(truth.sight(), truth.looks(), pose(turn), truth.owner()));
    }

    float[] depths(int turn) {
        return eye.depths(new RenderJob(truth.scene(), truth.looks(), pose(turn), truth.owner()));
    }

    /**
     * Writes the visible objects except the robot as JSON for other engines: boxes and cylinders as such, all else as
     * triangles.
     */
    void write(Path file) throws IOException {
        List<String> things = new ArrayList<>();
        for (SearObject object : simulation.getProject().getEnvironment()) {
            if (object instanceof Shape) {
                things.add(thing((Shape) object, file.toAbsolutePath().getParent()));
            }
        }
        double[][] poses = new double[TURNS][];
        for (int turn = 0; turn < TURNS; turn++) {
            poses[turn] = numbers(pose(turn));
        }
        double down = 2 * Math.toDegrees(Math.atan(Math.tan(Math.toRadians(FIELD_OF_VIEW / 2)) * HEIGHT / WIDTH));
        Files.writeString(file, String.format(Locale.ROOT,
            "{\"width\": %d, \"height\": %d, \"fovy\": %s, \"sun\": %s,\n\"poses\": %s,\n\"things\": [%s]}%n", WIDTH,
            HEIGHT, down, Arrays.toString(Daylight.toSun()), Arrays.deepToString(poses), String.join(",\n", things)));
    }

    private static double[] numbers(Pose pose) {
        return new double[] {pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw};
    }

    /**
     * Writes a shape's picture beside the world and returns its JSON fields: file and tile size, metres. Returns
     * nothing for models.
     */
    private static String picture(Shape shape, Path folder) throws IOException {
        String path = shape instanceof Model ? null : shape.getPicture();
        if (path == null || !path.endsWith(".png")) {
            return "";
        }
        Path copy = folder.resolve(path.replace('/', '-'));
        Files.write(copy, new Assets(folder).readPicture(path));
        return String.format(Locale.ROOT, ", \"picture\": \"%s\", \"tile\": %s", copy, shape.getPictureTile() == null
            ? 0 : shape.getPictureTile());
    }

    private String thing(Shape shape, Path folder) throws IOException {
        SurfaceMesh surface = simulation.getSurface(shape);
        Pose pose = simulation.getPose(shape.getName());
        float[] at = surface.getPositions();
        double[] low = {at[0], at[1], at[2]};
        double[] high = low.clone();
        for (int i = 0; i < at.length; i++) {
            low[i % 3] = Math.min(low[i % 3], at[i]);
            high[i % 3] = Math.max(high[i % 3], at[i]);
        }
        double[] half = {(high[0] - low[0]) / 2, (high[1] - low[1]) / 2, (high[2] - low[2]) / 2};
        boolean box = shape instanceof Box || shape instanceof Floor;
        if (box || shape instanceof Cylinder) {
            Pose middle = pose.times(new Pose((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2,
                0, 0, 0, 1));
            return String.format(Locale.ROOT, "{\"kind\": \"%s\", \"half\": %s, \"pose\": %s%s}", box ? "box"
                : "cylinder", Arrays.toString(half), Arrays.toString(numbers(middle)), picture(shape, folder));
        }
        return String.format(Locale.ROOT, "{\"kind\": \"mesh\", \"pose\": %s, \"vertices\": %s, \"indices\": %s}",
            Arrays.toString(numbers(pose)), Arrays.toString(at), Arrays.toString(surface.getIndices()));
    }
}
