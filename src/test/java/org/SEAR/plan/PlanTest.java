// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plan;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.plot.DrawingFiles;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Content of plans. The floor of 10 m is 608 points wide: a metre is 60.8 points, and the middle is at 320, 320. */
public class PlanTest {
    private static final double METRE = 60.8;
    private static final double MIDDLE = 320;

    @Rule
    public final ProjectRule project = new ProjectRule();
    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    /** Makes a robot at the origin that looks east, and a red wall 2 m ahead. */
    private SEARrobot room() {
        new Floor("floor", 10, 10, false);
        Box wall = new Box("wall", 6, 0.2, 1, 0);
        wall.move(0, 0.5, 2.1);
        wall.setColor("red");
        return Worlds.roomba("roomba", 0, 0, 0);
    }

    private String svg(boolean beams) throws Exception {
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            return DrawingFiles.svg(new PlanDrawing(Plan.of(world, beams)));
        }
    }

    /** Returns the numbers of the one element that matches. */
    private static double[] numbers(String svg, String element) {
        Matcher found = Pattern.compile(element).matcher(svg);
        assertTrue(element + " in " + svg, found.find());
        double[] numbers = new double[found.groupCount()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = Double.parseDouble(found.group(i + 1));
        }
        return numbers;
    }

    @Test
    public void northIsUpAndEastRight() throws Exception {
        room();
        String svg = svg(false);
        double[] wall = numbers(svg, "<polygon fill=\"#ff0000\"[^>]* points=\"([\\d.]+),([\\d.]+) ([\\d.]+),([\\d.]+)");
        assertEquals(MIDDLE + 3 * METRE, Math.max(wall[1], wall[3]), 0.01);
        assertTrue("to the right: " + svg, wall[0] > MIDDLE + 1.9 * METRE && wall[0] < MIDDLE + 2.3 * METRE);
        double[] arrow = numbers(svg, "fill-opacity=\"0.50\" stroke=\"#222222\" points=\"([\\d.]+),([\\d.]+)");
        assertTrue("it points to the right", arrow[0] > MIDDLE + 10);
        assertEquals(MIDDLE, arrow[1], 0.5);
        assertTrue(svg, svg.contains(">roomba 90\u00b0</text>") && svg.contains(">wall</text>")
            && !svg.contains(">floor</text>"));
        assertTrue(svg, svg.contains(">2 m</text>") && svg.contains(">after 0.00 s</text>")
            && svg.contains(">north is up</text>"));
    }

    @Test
    public void beamsEndAtTheirHits() throws Exception {
        SEARrobot robot = room();
        robot.addComponent(new LIDAR("lidar", 8, 180, 1, 0, 0.2, 0));
        robot.addComponent(new Distance("eye", "laser", 0, 0.3, 0, 0, 0, 0));
        String svg = svg(true);
        double[] laser = numbers(svg,
            "<line x1=\"([\\d.]+)\" y1=\"([\\d.]+)\" x2=\"([\\d.]+)\" y2=\"([\\d.]+)\" stroke=\"#d55e00\" "
                + "stroke-width=\"1.0\"");
        assertEquals(MIDDLE, laser[0], 0.01);
        assertEquals(MIDDLE + 2 * METRE, laser[2], 0.05);
        String fan = svg.substring(svg.indexOf("fill-opacity=\"0.15\""));
        assertEquals("from the scanner, 181 ends", 182, fan.substring(fan.indexOf("points=\"") + 8, fan.indexOf("\"/>"))
            .split(" ").length);
        assertFalse("without", svg(false).contains("#d55e00"));
        for (String x : fan.substring(fan.indexOf("points=\"") + 8, fan.indexOf("\"/>")).split("[, ]")) {
            assertTrue(x, Double.parseDouble(x) >= 0 && Double.parseDouble(x) <= 640);
        }
    }

    @Test
    public void largeGroundIsCroppedToItsObjects() throws Exception {
        room();
        new Floor("land", 2000, 2000, false);
        assertTrue("not to the edges", svg(false).contains(">2 m</text>"));
    }

    @Test
    public void manySimilarObjectsHaveNoNames() throws Exception {
        room();
        for (int i = 0; i < 6; i++) {
            new Box("post " + i, 0.1, 0.1, 1, 0).move(-4, 0.5, i - 3);
        }
        new Box("a & b", 0.2, 0.2, 1, 0).move(3, 0.5, 0);
        String svg = svg(false);
        assertFalse(svg, svg.contains(">post "));
        assertTrue(svg, svg.contains(">a &amp; b</text>"));
    }

    @Test
    public void anEmptyWorldIsAnEmptyPlan() throws Exception {
        new Floor("floor", 10, 10, false);
        assertTrue(svg(true).contains(">2 m</text>"));
    }

    @Test
    public void aPngHasTheSameColours() throws Exception {
        room();
        Path file = temporary.getRoot().toPath().resolve("plan.png");
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            DrawingFiles.save(new PlanDrawing(Plan.of(world, true)), file);
        }
        BufferedImage picture = ImageIO.read(file.toFile());
        assertEquals(640, picture.getWidth());
        assertEquals(0xff0000, picture.getRGB((int) (MIDDLE + 2.1 * METRE), (int) (MIDDLE + 2.5 * METRE)) & 0xffffff);
        assertEquals(0xffffff, picture.getRGB((int) (MIDDLE - 3 * METRE), (int) MIDDLE) & 0xffffff);
    }
}
