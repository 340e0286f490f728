// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.Slow;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.ProjectSwap;
import org.SEAR.robot.Robot;
import org.SEAR.sensors.LidarScan;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Models of every format in the simulated world: beams and contacts find them within a millimetre of their triangles.
 * Cramer's rule gives the expected ranges, independently of SEAR's code.
 */
@Category(Slow.class)
public class ModelsInTheWorldTest {
    private static final double MILLIMETRE = 0.001;
    private static final double EYE_HEIGHT = 0.12;
    private static final double EYE_FORWARD = 0.1;
    private static final double NOSE = 0.16;
    private static final double HALF_HEIGHT = 0.0381;
    private static final double HEAVY = 2000;
    /** A wedge like a doorstop without equal sides: 3 wide, 1 high, its front tilted back. */
    private static final float[] WEDGE = {-1, 0, -0.3f, 2, 0, -0.3f, 2, 0, 0.6f, -1, 0, 0.6f, -1, 1, 0.2f, 2, 1, 0.4f};
    private static final int[] WEDGE_TRIANGLES = {0, 1, 2, 0, 2, 3, 0, 4, 5, 0, 5, 1, 3, 2, 5, 3, 5, 4, 0, 3,
        4, 1, 5, 2};
    /** A block with its front at z = -0.25. */
    private static final float[] BLOCK = {-1, 0, -0.25f, 1, 0, -0.25f, 1, 0, 0.25f, -1, 0, 0.25f, -1, 0.4f, -0.25f, 1,
        0.4f, -0.25f, 1, 0.4f, 0.25f, -1, 0.4f, 0.25f};
    private static final int[] BLOCK_TRIANGLES = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5, 3, 2, 6, 3, 6,
        7, 0, 3, 7, 0, 7, 4, 1, 6, 2, 1, 5, 6};
    /** A plain that rises to a hill at its far end: 12 by 8, height 0 to 2. */
    private static final float[] HILL = {-6, 0, -4, 6, 0, -4, -6, 0, 2, 6, 0, 2, -6, 2, 4, 6, 2, 4};
    private static final int[] HILL_TRIANGLES = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3};

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static SEARrobot robot(double startHeight) {
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("dynamics", 400, 60, 0.3, 0.4, 10000, 0.1, 0, startHeight, 0, 0, 0, 0));
        robot.addWheel(new Wheel("front", 0.0381, 0.03, 0, 0, 0, 0.1));
        robot.addWheel(new Wheel("right", 0.0381, 0.03, 1, -0.16, 0, 0));
        robot.addWheel(new Wheel("left", 0.0381, 0.03, 1, 0.16, 0, 0));
        robot.addWheel(new Wheel("back", 0.0381, 0.03, 0, 0, 0, -0.1));
        robot.addComponent(new LIDAR("eye", 30, 180, 1, 0, EYE_HEIGHT, EYE_FORWARD, 0, 0, 0));
        return robot;
    }

    private static void boxRobot(double startHeight) {
        robot(startHeight).addComponent(new Box("body", 0.3, 2 * NOSE, 0.0762, 0));
    }

    private static void run(Simulation simulation, double seconds) {
        for (int i = 0; i < seconds / Simulation.STEP; i++) {
            simulation.step();
        }
    }

    /** Returns the corners in the world: scaled, turned about y, moved. */
    private static double[] placed(float[] corners, double scale, double heading, double... place) {
        double sin = Math.sin(Math.toRadians(heading));
        double cos = Math.cos(Math.toRadians(heading));
        double[] world = new double[corners.length];
        for (int i = 0; i < corners.length; i += 3) {
            double x = corners[i] * scale;
            double z = corners[i + 2] * scale;
            world[i] = place[0] + x * cos + z * sin;
            world[i + 1] = place[1] + corners[i + 1] * scale;
            world[i + 2] = place[2] - x * sin + z * cos;
        }
        return world;
    }

    private static double determinant(double[] a, double[] b, double[] c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1])
            + c[0] * (a[1] * b[2] - a[2] * b[1]);
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    private static double[] corner(double[] corners, int index) {
        return new double[] {corners[index * 3], corners[index * 3 + 1], corners[index * 3 + 2]};
    }

    /** Returns the distance along a ray to the nearest triangle. */
    private static double nearest(double[] corners, int[] triangles, double[] from, double[] direction) {
        double nearest = Double.POSITIVE_INFINITY;
        double[] back = {-direction[0], -direction[1], -direction[2]};
        for (int i = 0; i < triangles.length; i += 3) {
            double[] a = corner(corners, triangles[i]);
            double[] ab = minus(corner(corners, triangles[i + 1]), a);
            double[] ac = minus(corner(corners, triangles[i + 2]), a);
            double[] start = minus(from, a);
            double whole = determinant(ab, ac, back);
            double u = determinant(start, ac, back) / whole;
            double v = determinant(ab, start, back) / whole;
            double along = determinant(ab, ac, start) / whole;
            if (u >= 0 && v >= 0 && u + v <= 1 && along > 0) {
                nearest = Math.min(nearest, along);
            }
        }
        return nearest;
    }

    /**
     * Compares each beam with the triangles. Beams within a tenth of a degree of an edge may hit or miss.
     * @return the number of beams that hit
     */
    private static int assertSeen(String what, LidarScan scan, double[] corners, int[] triangles, double... eye) {
        int hits = 0;
        for (int i = 0; i < scan.size(); i++) {
            double[] expected = new double[3];
            for (int j = 0; j < 3; j++) {
                double angle = Math.toRadians(scan.angle(i) + (j - 1) * 0.1);
                expected[j] = nearest(corners, triangles, eye, new double[] {Math.sin(angle), 0, Math.cos(angle)});
            }
            boolean inside = Double.isFinite(expected[0]) && Double.isFinite(expected[1])
                && Double.isFinite(expected[2]);
            if (inside && expected[1] < 30 || expected[0] == expected[2]) {
                assertEquals(what + " at " + scan.angle(i) + " degrees", expected[1], scan.range(i), MILLIMETRE);
                hits += inside ? 1 : 0;
            }
        }
        return hits;
    }

    @Test
    public void asAnObstacleEachFormatIsSeenAtItsTriangles() throws Exception {
        ModelFiles wedge = new ModelFiles(WEDGE, WEDGE_TRIANGLES, 0.1f, 0, 0.2f);
        double[] corners = placed(WEDGE, 1.5, 0, 0, 0, 0);
        for (int i = 0; i < corners.length; i += 3) {
            corners[i] += 0.15;
            corners[i + 2] += 0.3;
        }
        float[] moved = new float[corners.length];
        for (int i = 0; i < moved.length; i++) {
            moved[i] = (float) corners[i];
        }
        double[] world = placed(moved, 1, 30, 0.2, 0, 3);
        for (String ending : ModelLoader.ENDINGS) {
            ProjectSwap.delete(project.folder());
            new Floor("floor", 50, 50);
            boxRobot(0.1);
            Model model = new Model("wedge", wedge.put(project, ending));
            model.scale(1.5, 1.5, 1.5);
            model.rotate(0, 30, 0);
            model.move(0.2, 0, 3);
            try (Simulation simulation = Simulation.load(project.folder(), 1)) {
                simulation.step();
                double height = simulation.getPose("robot").y;
                LidarScan scan = (LidarScan) simulation.read("eye");
                assertTrue(assertSeen(ending, scan, world, WEDGE_TRIANGLES, 0, height + EYE_HEIGHT, EYE_FORWARD) > 40);
            }
        }
    }

    /**
     * Drives against an obstacle in front.
     * @return final position of the robot's foremost point
     */
    private double stopped(double[]... points) throws Exception {
        try (Simulation simulation = Simulation.load(project.folder(), 1)) {
            Robot robot = simulation.getRobots().get(0);
            run(simulation, 0.5);
            robot.drive(0.1, Double.POSITIVE_INFINITY);
            run(simulation, 10);
            assertTrue(robot.getHardware().isBumpedLeft() || robot.getHardware().isBumpedRight());
            double foremost = Double.NEGATIVE_INFINITY;
            for (double[] point : points) {
                foremost = Math.max(foremost, robot.getPose().transform(point[0], point[1], point[2])[2]);
            }
            return foremost;
        }
    }

    @Test
    public void asAnObstacleEachFormatIsHitAtItsTriangles() throws Exception {
        ModelFiles block = new ModelFiles(BLOCK, BLOCK_TRIANGLES, 0, -0.2f, 0);
        for (double mass : new double[] {0, HEAVY}) {
            for (String ending : ModelLoader.ENDINGS) {
                ProjectSwap.delete(project.folder());
                new Floor("floor", 50, 50);
                boxRobot(0.1);
                new Model("block", block.put(project, ending), mass).move(0, 0.2, 0.85);
                assertEquals(ending + " of " + mass + " kg", 0.6,
                    stopped(new double[] {0, HALF_HEIGHT, NOSE}, new double[] {0, -HALF_HEIGHT, NOSE}), MILLIMETRE);
            }
        }
    }

    @Test
    public void asAPartOfARobotEachFormatHitsWithItsTriangles() throws Exception {
        ModelFiles block = new ModelFiles(new float[] {-0.1f, 0, 0, 0.1f, 0, 0, 0, 0, 0.3f, 0, 0.08f, 0.1f},
            new int[] {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}, 0, 0, -0.05f);
        for (String ending : ModelLoader.ENDINGS) {
            ProjectSwap.delete(project.folder());
            new Floor("floor", 50, 50);
            robot(0.1).addComponent(new Model("body", block.put(project, ending)));
            new Box("wall", 4, 0.2, 1, 0).move(0, 0, 0.8);
            assertEquals(ending, 0.7, stopped(new double[] {0, 0, 0.25}), MILLIMETRE);
        }
    }

    @Test
    public void asATerrainEachFormatCarriesAndIsSeenAtItsTriangles() throws Exception {
        ModelFiles hill = new ModelFiles(HILL, HILL_TRIANGLES, 100, 7, -30);
        new Floor("floor", 50, 50);
        boxRobot(0.1);
        double onTheFloor;
        try (Simulation simulation = Simulation.load(project.folder(), 1)) {
            run(simulation, 1);
            onTheFloor = simulation.getPose("robot").y;
        }
        double[] world = placed(HILL, 1, 0, 0, 0.5, 0);
        for (String ending : ModelLoader.ENDINGS) {
            ProjectSwap.delete(project.folder());
            boxRobot(0.6);
            Model terrain = new Model("hill", hill.put(project, ending));
            terrain.setTerrain(true);
            terrain.move(0, 0.5, 0);
            try (Simulation simulation = Simulation.load(project.folder(), 1)) {
                run(simulation, 1);
                double height = simulation.getPose("robot").y;
                assertEquals(ending, onTheFloor + 0.5, height, MILLIMETRE);
                LidarScan scan = (LidarScan) simulation.read("eye");
                assertTrue(assertSeen(ending, scan, world, HILL_TRIANGLES, 0, height + EYE_HEIGHT, EYE_FORWARD) > 100);
            }
        }
    }
}
