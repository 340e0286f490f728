// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.SEAR.HowMany;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Sphere;
import org.SEAR.Slow;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.Progress;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Falling objects stay above the ground from any height and at any phase of the step. */
@Category(Slow.class)
public class DropsTest {
    private static final int DROPS = HowMany.of("sear.drops", 10000);
    private static final int AT_ONCE = 500;
    private static final int FAST_DROPS = HowMany.of("sear.fastDrops", 500);
    private static final int FAST_AT_ONCE = 250;
    private static final long SEED = Long.getLong("sear.seed", 4);
    private static final double APART = 6;
    /** Margin of the ground, metres: scattered objects must not fall off its edge and count as lost. */
    private static final double AROUND = 100;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void nothingThatFallsIsLost() throws Exception {
        assertEquals("seed " + SEED, Collections.emptyList(), drops(DROPS, AT_ONCE, 0, 50, 4, Integer.MAX_VALUE));
    }

    /** From 130 m they arrive with 50 m/s. */
    @Test
    public void nothingAndNoRobotIsLostAt50MetresASecond() throws Exception {
        assertEquals("seed " + SEED, Collections.emptyList(), drops(FAST_DROPS, FAST_AT_ONCE, 40, 130, 6, 4));
    }

    /**
     * Drops objects with robots among them.
     * @param low least height, metres, likewise high
     * @param seconds duration of the run
     * @param robotEach every n-th object is a robot
     * @return the lost objects
     */
    private List<String> drops(int all, int atOnce, double low, double high, double seconds, int robotEach)
        throws Exception {
        Random random = new Random(SEED);
        List<String> lost = new ArrayList<>();
        for (int done = 0; done < all; done += atOnce) {
            boolean mesh = robotEach < atOnce ? done / atOnce % 2 == 1 : random.nextBoolean();
            int count = Math.min(atOnce, all - done);
            double side = APART * Math.ceil(Math.sqrt(count)) + 2 * AROUND;
            Bundle.newProject(project.folder(), Progress.NONE);
            if (mesh) {
                ground(side, random);
            } else {
                new Floor("ground", side, side).move(side / 2 - AROUND, 0, side / 2 - AROUND);
            }
            List<String> what = new ArrayList<>();
            int row = (int) Math.ceil(Math.sqrt(count));
            for (int i = 0; i < count; i++) {
                double size = 0.02 * Math.pow(50, random.nextDouble());
                double height = size + low + (high - low) * random.nextDouble();
                String kind = i % robotEach == robotEach - 1
                    ? robot("thing" + i, size, height, APART * (i % row), APART * (i / row), random)
                    : thing("thing" + i, size, height, APART * (i % row), APART * (i / row), random);
                what.add((mesh ? "mesh " : "floor ") + kind + " of " + size + " from " + height + ", number "
                    + (done + i));
            }
            run(seconds, what, lost);
        }
        return lost;
    }

    private static String thing(String name, double size, double height, double x, double z, Random random) {
        double mass = Math.pow(10, 3 * random.nextDouble() - 2);
        SearObject thing;
        switch (random.nextInt(4)) {
            case 0:
                thing = new Box(name, size, size * (0.2 + random.nextDouble()), size, mass);
                break;
            case 1:
                thing = new Cylinder(name, size / 2, size * (0.3 + random.nextDouble()), mass);
                break;
            case 2:
                thing = new Sphere(name, size / 2, mass);
                ((Sphere) thing).scale(1, random.nextBoolean() ? 1 : 0.3 + random.nextDouble(), 1);
                break;
            default:
                thing = new Cone(name, size / 2, size, mass);
        }
        thing.move(x, height + 0.2, z);
        thing.rotate(360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
        return thing.getClass().getSimpleName();
    }

    private static String robot(String name, double size, double height, double x, double z, Random random) {
        double track = 0.05 + size / 2;
        Worlds.cart(name, 1 + 10 * random.nextDouble(), 0.3 * track, track, new double[] {0}, -track, x, z,
            360 * random.nextDouble()).move(0, height, 0);
        return "robot";
    }

    private void run(double seconds, List<String> what, List<String> lost) throws Exception {
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, seconds);
            for (int i = 0; i < what.size(); i++) {
                if (simulation.getPose("thing" + i).y < -0.05) {
                    lost.add(what.get(i) + " is at " + simulation.getPose("thing" + i).y);
                }
            }
        }
    }

    /** Makes a sheet of triangles without thickness. */
    private void ground(double side, Random random) throws Exception {
        Path file = project.folder().resolve("assets/sheet.obj");
        Files.createDirectories(file.getParent());
        StringBuilder text = new StringBuilder();
        int cells = 60;
        for (int i = 0; i <= cells; i++) {
            for (int k = 0; k <= cells; k++) {
                text.append("v ").append(i * side / cells - AROUND).append(" 0 ").append(k * side / cells - AROUND)
                    .append('\n');
            }
        }
        for (int i = 0; i < cells; i++) {
            for (int k = 0; k < cells; k++) {
                int a = i * (cells + 1) + k + 1;
                int b = a + cells + 1;
                text.append("f ").append(a).append(' ').append(a + 1).append(' ').append(b + 1).append('\n');
                text.append("f ").append(a).append(' ').append(b + 1).append(' ').append(b).append('\n');
            }
        }
        Files.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
        new Model("ground", "sheet.obj");
    }
}
