package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Sphere;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** Whatever falls, from any height and at any phase of the step, stays above the ground. */
public class DropsTest {
    private static final int DROPS = Integer.getInteger("sear.drops", 10000);
    private static final int AT_ONCE = 500;
    private static final double APART = 6;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void nothingThatFallsIsLost() throws Exception {
        long seed = Long.getLong("sear.seed", 4);
        Random random = new Random(seed);
        List<String> lost = new ArrayList<>();
        for (int done = 0; done < DROPS; done += AT_ONCE) {
            lost.addAll(drop(random, Math.min(AT_ONCE, DROPS - done), done));
        }
        assertEquals("seed " + seed, Collections.emptyList(), lost);
    }

    private List<String> drop(Random random, int count, int first) throws Exception {
        double side = APART * Math.ceil(Math.sqrt(count)) + 20;
        boolean mesh = random.nextBoolean();
        if (mesh) {
            ground(side, random);
        } else {
            new Floor("ground", side, side).move(side / 2 - 10, 0, side / 2 - 10);
        }
        List<SearObject> things = new ArrayList<>();
        List<String> what = new ArrayList<>();
        int row = (int) Math.ceil(Math.sqrt(count));
        for (int i = 0; i < count; i++) {
            double size = 0.02 * Math.pow(50, random.nextDouble());
            double height = size + 50 * random.nextDouble();
            String name = "thing" + i;
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
            thing.move(APART * (i % row), height + 0.2, APART * (i / row));
            thing.rotate(360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
            things.add(thing);
            what.add((mesh ? "mesh " : "floor ") + thing.getClass().getSimpleName() + " of " + size + " from " + height + ", number " + (first + i));
        }
        List<String> lost = new ArrayList<>();
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 4);
            for (int i = 0; i < count; i++) {
                if (simulation.getPose("thing" + i).y < -0.05) {
                    lost.add(what.get(i) + " is at " + simulation.getPose("thing" + i).y);
                }
            }
        }
        return lost;
    }

    /** A sheet of triangles without a thick side. */
    private void ground(double side, Random random) throws Exception {
        Path file = project.folder().resolve("assets/sheet.obj");
        Files.createDirectories(file.getParent());
        StringBuilder text = new StringBuilder();
        int cells = 30;
        for (int i = 0; i <= cells; i++) {
            for (int k = 0; k <= cells; k++) {
                text.append("v ").append(i * side / cells - 10).append(" 0 ").append(k * side / cells - 10).append('\n');
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
