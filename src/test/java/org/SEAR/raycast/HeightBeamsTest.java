// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.Random;
import org.SEAR.Slow;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.solid.Grounds;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Beams over a height field hit, to the bit, the points that they hit over a mesh of the same triangles. */
@Category(Slow.class)
public class HeightBeamsTest {
    private static final int BEAMS = 361;
    private static final int FIELDS = 60;

    private final Random random = new Random(19);
    private HeightField field;
    private final Hit hit = new Hit();
    private final Hit meshHit = new Hit();

    private double between(double low, double high) {
        return low + random.nextDouble() * (high - low);
    }

    /** Makes ground of random size, roughness and place; every third one has flat parts and steps. */
    private HeightField ground(int number) {
        int rows = 2 + random.nextInt(number % 4 == 0 ? 4 : 60);
        int columns = 2 + random.nextInt(number % 5 == 0 ? 3 : 60);
        double spacing = Math.pow(10, between(-1.5, 1.5));
        double other = spacing * between(0.5, 2);
        double rough = spacing * between(0, 3);
        float[] heights = new float[rows * columns];
        for (int i = 0; i < heights.length; i++) {
            double height = Math.sin(i / columns * 0.3) * Math.cos(i % columns * 0.4) * rough * 3
                + between(-rough, rough);
            heights[i] = (float) (number % 3 == 0 ? Math.rint(height / spacing) * spacing : height);
        }
        double away = number % 2 == 0 ? 0.5 * rows * spacing : between(-1e4, 1e4);
        return new HeightField(rows, columns, -away, -0.5 * columns * other, spacing, other, heights);
    }

    private void place(BeamScene scene, int shape, Pose pose) {
        scene.setPose(shape, pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw);
        scene.commit();
    }

    @Test
    public void beamsAndFansMeetTheSameToTheBitAsOverTheMesh() {
        for (int number = 0; number < FIELDS; number++) {
            field = ground(number);
            BeamScene scene = new BeamScene();
            BeamScene mesh = new BeamScene();
            Pose pose = number % 3 == 2 ? Pose.ofDegrees(between(-5, 5), between(-5, 5), between(-5, 5),
                between(-180, 180), between(-180, 180), between(-180, 180)) : Pose.IDENTITY;
            place(scene, scene.addHeights(field, BeamScene.WORLD), pose);
            place(mesh, mesh.addMesh(Grounds.triangles(field), 1, 1, 1, BeamScene.WORLD), pose);
            int met = 0;
            for (int i = 0; i < 1500; i++) {
                met += beam("field " + number + " beam " + i, scene, mesh, pose, i) ? 1 : 0;
            }
            assertTrue("of 1500 beams over field " + number + " only " + met + " met it", met > 100);
            for (int i = 0; i < 30; i++) {
                fan("field " + number + " fan " + i, scene, mesh, pose);
            }
        }
    }

    /**
     * Returns a place above, on, below or beside the field in its frame; half of them on samples, edges or diagonals.
     */
    private double[] origin(int kind) {
        double row = between(-0.2, 1.2) * (field.rows - 1);
        double column = between(-0.2, 1.2) * (field.columns - 1);
        if (kind % 2 == 0) {
            row = Math.max(0, Math.min(field.rows - 1, Math.rint(row)));
            column = kind % 4 == 0 ? Math.max(0, Math.min(field.columns - 1, Math.rint(column))) : column;
        }
        double x = field.lowX + row * field.spacingX;
        double z = field.lowZ + column * field.spacingZ;
        if (kind % 2 == 0) {
            x = field.x((int) row);
            z = kind % 4 == 0 ? field.z((int) column) : z;
        }
        double ground = field.height(x, z);
        double y = Double.isNaN(ground) ? 0 : kind % 6 == 0 ? ground : ground + between(-4, 8) * field.spacingX;
        return new double[] {x, y, z};
    }

    private double[] direction(int kind) {
        double[] d;
        switch (kind % 7) {
            case 0:
                d = new double[] {0, random.nextBoolean() ? 1 : -1, 0};
                break;
            case 1:
                d = new double[] {random.nextBoolean() ? 1 : -1, 0, 0};
                break;
            case 2:
                d = new double[] {between(-1e-9, 1e-9), between(-0.1, 0.1), random.nextBoolean() ? 1 : -1};
                break;
            case 3:
                d = new double[] {field.spacingX, between(-1, 1) * field.spacingX, random.nextBoolean() ? field.spacingZ
                    : -field.spacingZ};
                break;
            case 4:
                double[] here = origin(0);
                double[] there = origin(0);
                d = new double[] {there[0] - here[0], there[1] - here[1] + 1e-3, there[2] - here[2]};
                break;
            default:
                d = new double[] {between(-1, 1), between(-0.3, 0.1), between(-1, 1)};
        }
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        return new double[] {d[0] / length, d[1] / length, d[2] / length};
    }

    private boolean beam(String what, BeamScene scene, BeamScene mesh, Pose pose, int kind) {
        double[] from = origin(random.nextInt(12));
        double[] towards = direction(kind);
        double[] o = pose.transform(from[0], from[1], from[2]);
        double[] d = pose.rotate(towards[0], towards[1], towards[2]);
        double range = kind % 4 == 0 ? Double.MAX_VALUE : between(0, 30) * field.spacingX;
        double expected = mesh.cast(o[0], o[1], o[2], d[0], d[1], d[2], range, BeamScene.WORLD, meshHit);
        double t = scene.cast(o[0], o[1], o[2], d[0], d[1], d[2], range, BeamScene.WORLD, hit);
        assertEquals(what, expected, t, 0);
        if (t < Double.POSITIVE_INFINITY) {
            assertEquals(what, t, hit.distance, 0);
            assertEquals(what, 1, Math.sqrt(hit.nx * hit.nx + hit.ny * hit.ny + hit.nz * hit.nz), 1e-12);
            double[] up = pose.rotateBack(hit.nx, hit.ny, hit.nz);
            assertTrue(what + ": normals point up", up[1] > 0);
        }
        return t < Double.POSITIVE_INFINITY;
    }

    private void fan(String what, BeamScene scene, BeamScene mesh, Pose pose) {
        int count = random.nextInt(3) == 0 ? 1 + random.nextInt(31) : BEAMS;
        double[] ranges = new double[count];
        double[] expected = new double[count];
        double[] o = origin(random.nextInt(12));
        Pose level = Pose.ofDegrees(o[0], o[1], o[2], 0, between(-180, 180), 0);
        Pose tilted = Pose.ofDegrees(o[0], o[1], o[2], between(-180, 180), between(-180, 180), between(-180, 180));
        Pose from = pose.times(random.nextBoolean() ? level : tilted);
        double range = random.nextInt(4) == 0 ? 1e9 : between(0, 40) * field.spacingX;
        double step = count < BEAMS ? between(0, 0.2) : random.nextBoolean() ? Math.PI / 360 : 2 * Math.PI / BEAMS;
        double start = between(-4, 4);
        int[] shapes = new int[count];
        scene.castFan(from, start, step, count, range, BeamScene.WORLD, ranges, shapes);
        mesh.castFan(from, start, step, count, range, BeamScene.WORLD, expected, null);
        assertArrayEquals(what + " from " + from, expected, ranges, 0);
        for (int i = 0; i < count; i++) {
            assertEquals(what, ranges[i] < Double.POSITIVE_INFINITY, shapes[i] == 0);
        }
    }

    /** Steep beams on gentle ground: none may pass beside a ridge. */
    @Test
    public void noBeamSlipsThroughBetweenTwoTriangles() {
        field = new HeightField(40, 40, -2, -2, 0.1, 0.1, ground(0.4, 1600));
        BeamScene scene = new BeamScene();
        scene.addHeights(field, BeamScene.WORLD);
        scene.commit();
        for (int i = 0; i < 200_000; i++) {
            int row = 1 + random.nextInt(38);
            int column = 1 + random.nextInt(38);
            boolean vertical = i % 5 == 0;
            double share = vertical && i % 3 == 0 ? 0 : random.nextDouble();
            boolean diagonal = i % 2 == 0;
            double x = field.x(row) + (diagonal ? share * ((double) field.x(row + 1) - field.x(row)) : 0);
            double z = field.z(column) + share * ((double) field.z(column + 1) - field.z(column));
            double ox = x + (vertical ? 0 : between(-3, 3));
            double oz = z + (vertical ? 0 : between(-3, 3));
            double dy = field.height(x, z) - 5;
            double length = Math.sqrt((x - ox) * (x - ox) + dy * dy + (z - oz) * (z - oz));
            double t = scene.cast(ox, 5, oz, (x - ox) / length, dy / length, (z - oz) / length, 50,
                BeamScene.WORLD, null);
            assertTrue("beam " + i + " at " + x + " " + z + ": " + t + " of " + length, t <= length + 1e-6);
        }
    }

    private float[] ground(double size, int count) {
        float[] heights = new float[count];
        for (int i = 0; i < count; i++) {
            heights[i] = (float) between(0, size / 10);
        }
        return heights;
    }

    @Test
    public void castingAllocatesNothing() {
        field = new HeightField(300, 300, -15, -15, 0.1, 0.1, ground(2, 90_000));
        BeamScene scene = new BeamScene();
        scene.addHeights(field, BeamScene.WORLD);
        scene.commit();
        double[] ranges = new double[BEAMS];
        double[] directions = {0, -0.6, 0.8, 0, -0.8, 0.6, 0.1, -0.8, 0.59};
        double[] reach = {5, 5, 5};
        double[] shortest = new double[1];
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        Pose pose = Pose.ofDegrees(0.3, 0.15, 0.4, 2, 30, 1);
        long least = Long.MAX_VALUE;
        for (int round = 0; round < 5; round++) {
            long before = threads.getThreadAllocatedBytes(id);
            for (int i = 0; i < 200; i++) {
                scene.castFan(pose, -1, 0.005, BEAMS, 8, BeamScene.WORLD, ranges, null);
                scene.cast(pose.x, pose.y, pose.z, 0, -0.6, 0.8, 8, BeamScene.WORLD, hit);
                scene.castBundle(pose.x, pose.y, pose.z, directions, reach, BeamScene.WORLD, shortest);
            }
            least = Math.min(least, threads.getThreadAllocatedBytes(id) - before);
        }
        assertTrue(least + " bytes for 200 fans and 800 beams", least < 1000);
    }

    @Test
    public void aFanAndABeamLookAtFewBlocksAndTriangles() {
        float[] heights = new float[317 * 317];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = (float) (Math.sin(i / 317 * 0.08) * Math.cos(i % 317 * 0.06)
                + 0.3 * Math.sin(i / 317 * 0.21 + i % 317 * 0.17));
        }
        field = new HeightField(317, 317, -10, -10, 0.0633, 0.0633, heights);
        BeamScene scene = new BeamScene();
        scene.addHeights(field, BeamScene.WORLD);
        scene.commit();
        RayCaster work = BeamScene.casters().rays;
        double[] ranges = new double[BEAMS];
        long nodes = work.nodes();
        long triangles = work.triangles;
        for (int i = 0; i < 100; i++) {
            double x = between(-5, 5);
            double z = between(-5, 5);
            scene.castFan(Pose.ofDegrees(x, field.height(x, z) + 0.3, z, 0, between(-180, 180), 0), -Math.PI / 2,
                Math.PI / 360, BEAMS, 8, BeamScene.WORLD, ranges, null);
        }
        String fan = (work.nodes() - nodes) / 100 + " blocks and " + (work.triangles - triangles) / 100
            + " triangles a fan";
        assertTrue(fan, work.nodes() - nodes < 100 * 200 && work.triangles - triangles < 100 * 550);
        nodes = work.nodes();
        triangles = work.triangles;
        for (int i = 0; i < 1000; i++) {
            double x = between(-5, 5);
            double z = between(-5, 5);
            double angle = between(-Math.PI, Math.PI);
            scene.cast(x, field.height(x, z) + 0.3, z, Math.sin(angle), 0, Math.cos(angle), 8, BeamScene.WORLD, null);
        }
        String beam = (work.nodes() - nodes) / 1000.0 + " blocks and " + (work.triangles - triangles) / 1000.0
            + " triangles a beam";
        assertTrue(beam, work.nodes() - nodes < 1000 * 30 && work.triangles - triangles < 1000 * 8);
    }
}
