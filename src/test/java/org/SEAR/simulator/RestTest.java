package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** What is dropped ends at rest on a face, a rim or a side, not on an edge or a corner, and not in the floor. */
public class RestTest {
    private static final int THINGS = 200;
    private static final double APART = 1.5;
    /** Cosine of one degree. */
    private static final double FLAT = 0.99985;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void everyCubeEndsOnAFace() throws Exception {
        for (long seed = 1; seed <= 3; seed++) {
            assertEquals("seed " + seed, Collections.emptyList(), drop(new Random(seed), 0));
        }
    }

    private List<String> drop(Random random, int kind) throws Exception {
        org.SEAR.project.bundle.Bundle.newProject(project.folder());
        int row = (int) Math.ceil(Math.sqrt(THINGS));
        new Floor("ground", 60, 60);
        double[] sizes = new double[THINGS];
        for (int i = 0; i < THINGS; i++) {
            sizes[i] = 0.05 + 0.25 * random.nextDouble();
            SearObject thing = new Box("thing" + i, sizes[i], sizes[i], sizes[i], 1);
            thing.move(APART * (i % row - row / 2), 0.5 + sizes[i], APART * (i / row - row / 2));
            thing.rotate(360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
        }
        List<String> wrong = new ArrayList<>();
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 10);
            double deepest = 0;
            for (int i = 0; i < THINGS; i++) {
                Pose pose = simulation.getPose("thing" + i);
                double best = 0;
                double lowest = pose.y;
                double[][] axes = {pose.rotate(1, 0, 0), pose.rotate(0, 1, 0), pose.rotate(0, 0, 1)};
                double half = 0;
                for (double[] axis : axes) {
                    best = Math.max(best, Math.abs(axis[1]));
                    half += Math.abs(axis[1]) * sizes[i] / 2;
                }
                double[] middle = pose.transform(0, 0, 0);
                deepest = Math.max(deepest, half - Math.abs(middle[1]));
                if (best < FLAT) {
                    wrong.add("thing" + i + " " + best + " y " + pose.y + " size " + sizes[i]);
                }
            }
            System.err.println("not on a face: " + wrong.size() + ", deepest " + deepest);
        }
        return wrong;
    }
}
