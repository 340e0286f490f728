// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import org.SEAR.POJOs.Distance;
import org.SEAR.Slow;
import org.SEAR.project.ProjectRule;
import org.SEAR.raycast.BeamScene;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * The beams of real products see a pole where their data sheets say, with an intersection over union of at least 90 %.
 * Each test also draws its picture into {@code build/pictures}; pictures of the documentation must be up to date.
 */
@Category(Slow.class)
public class BeamOutlineTest {
    private static final double ENOUGH = 0.9;
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", "."));

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static void assertSeen(String beam, double cell, String picture) throws IOException {
        BeamOutline outline = BeamOutline.all().stream().filter(each -> each.beam.equals(beam)).findFirst()
            .orElseThrow();
        BeamGrid grid = new BeamGrid(outline, cell);
        Path drawn = ROOT.resolve("build/pictures").resolve(picture);
        grid.draw(drawn);
        assertTrue(beam + ": overlap " + grid.overlap(), grid.overlap() >= ENOUGH);
        assertArrayEquals("docs/pictures/" + picture + " is old: copy " + drawn + " there", Files.readAllBytes(drawn),
            Files.readAllBytes(ROOT.resolve("docs/pictures").resolve(picture)));
    }

    @Test
    public void pingSeesABroomPole() throws IOException {
        assertSeen("PING)))", 0.02, "beam-ping.svg");
    }

    @Test
    public void ez0SeesARod() throws IOException {
        assertSeen("LV-EZ0", 0.02, "beam-ez0.svg");
    }

    @Test
    public void ez1SeesARod() throws IOException {
        assertSeen("LV-EZ1", 0.02, "beam-ez1.svg");
    }

    @Test
    public void theBeamsForThinDowelsSeeThem() throws IOException {
        assertSeen("LV-EZ0-A", 0.025, "beam-ez0-a.svg");
        assertSeen("LV-EZ0-B", 0.025, "beam-ez0-b.svg");
        assertSeen("LV-EZ1-A", 0.025, "beam-ez1-a.svg");
        assertSeen("LV-EZ1-B", 0.025, "beam-ez1-b.svg");
    }

    @Test
    public void wallsAheadAreSeenToTheProductsRange() {
        ScriptedTruth truth = new ScriptedTruth();
        truth.scene = new BeamScene();
        int wall = truth.scene.addBox(5, 2, 0.1, BeamScene.WORLD);
        for (Object[] each : List.of(new Object[] {"PING)))", 3.0}, new Object[] {"LV-EZ0", 6.45},
            new Object[] {"LV-EZ1", 6.1})) {
            DistanceSensor sensor = new DistanceSensor(new Distance("sensor", (String) each[0]), 1);
            double range = (Double) each[1];
            for (double distance : new double[] {0.5, range - 0.01}) {
                truth.scene.setPose(wall, 0, 0, distance + 0.1, 0, 0, 0, 1);
                truth.scene.commit();
                truth.step++;
                assertEquals(distance, sensor.read(truth).getDistance(), 1e-9);
            }
            assertEquals(range, sensor.read(truth).getPattern().getMaxRange(), 0);
        }
    }
}
