// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Plots as files: positions of lines and marks, and rejected input. */
public class PlotTest {
    private static final double[] TIMES = {0, 1, 2, 3, 4};

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private String svg(Plot plot) throws IOException {
        Path file = temporary.getRoot().toPath().resolve("plot.svg");
        plot.save(file);
        return Files.readString(file);
    }

    private static String marks(double least, double most, boolean whole) {
        Axis axis = new Axis(least, most, whole);
        return axis.marks().stream().map(axis::label).collect(Collectors.joining(" "));
    }

    private static void assertRefused(String words, ThrowingRunnable work) throws IOException {
        try {
            work.run();
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains(words));
            return;
        }
        throw new AssertionError("nothing was refused: " + words);
    }

    private interface ThrowingRunnable {
        void run() throws IOException;
    }

    @Test
    public void marksAreAtRoundNumbers() {
        assertEquals("0 1 2 3 4", marks(0, 4, false));
        assertEquals("0 0.1 0.2 0.3 0.4 0.5 0.6", marks(0, 0.52, true));
        assertEquals("-2 -1 0 1 2", marks(-1.7, 1.9, true));
        assertEquals("1000 1200 1400 1600 1800 2000", marks(1000, 2000, true));
    }

    @Test
    public void oneNumberAloneHasAnAxisAroundIt() {
        Axis axis = new Axis(5, 5, true);
        assertTrue(axis.from < 5 && axis.to > 5);
        Axis zero = new Axis(0, 0, true);
        assertTrue(zero.from < 0 && zero.to > 0);
    }

    @Test
    public void aLineGoesFromCornerToCorner() throws IOException {
        Plot plot = new Plot("time (s)", TIMES);
        plot.add("distance", "m", new double[] {0, 1, 2, 3, 4});
        String svg = svg(plot);
        assertTrue(svg, svg.contains("points=\"105.00,300.00 296.25,235.00 487.50,170.00 678.75,105.00 "
            + "870.00,40.00\""));
        assertTrue(svg, svg.contains(">time (s)</text>") && svg.contains(">distance (m)</text>")
            && svg.contains(">distance</text>"));
    }

    @Test
    public void linesOfOneUnitShareABox() throws IOException {
        Plot plot = new Plot("time (s)", TIMES);
        plot.add("left", "m", TIMES);
        plot.add("speed", "m/s", TIMES);
        plot.add("right", "m", TIMES);
        String svg = svg(plot);
        assertTrue(svg, svg.contains("height=\"660\""));
        assertTrue(svg, svg.contains(">m</text>") && svg.contains(">speed (m/s)</text>"));
    }

    @Test
    public void missingValuesAreGaps() throws IOException {
        Plot plot = new Plot("time (s)", TIMES);
        plot.add("distance", "m", new double[] {0, 1, Double.NaN, 3, 4});
        String svg = svg(plot);
        List<String> lines = Arrays.stream(svg.split("\n")).filter(line -> line.startsWith("<polyline"))
            .collect(Collectors.toList());
        assertEquals(svg, 2, lines.size());
        assertTrue(svg, lines.get(0).contains("points=\"105.00,300.00 296.25,235.00\""));
    }

    @Test
    public void namesAreText() throws IOException {
        Plot plot = new Plot("a < b & c", TIMES);
        plot.add("<b>", "", TIMES);
        String svg = svg(plot);
        assertTrue(svg, svg.contains("a &lt; b &amp; c") && svg.contains("&lt;b&gt;"));
        assertFalse(svg, svg.contains("<b>"));
    }

    @Test
    public void aPngHasTheLineInItsColour() throws IOException {
        Plot plot = new Plot("time (s)", TIMES);
        plot.add("distance", "m", new double[] {2, 2, 2, 2, 2});
        Path file = temporary.getRoot().toPath().resolve("plot.png");
        plot.save(file);
        BufferedImage picture = ImageIO.read(file.toFile());
        assertEquals(900, picture.getWidth());
        assertEquals(360, picture.getHeight());
        assertEquals(0xff0072b2, picture.getRGB(500, 170));
        assertEquals(0xffffffff, picture.getRGB(895, 5));
    }

    @Test
    public void undrawableInputIsReported() throws IOException {
        Path folder = temporary.getRoot().toPath();
        Plot plot = new Plot("time (s)", TIMES);
        assertRefused("\"distance\" has 2 values, and \"time (s)\" has 5, legal: the same number",
            () -> plot.add("distance", "m", new double[2]));
        assertRefused("there is nothing to draw", () -> plot.save(folder.resolve("a.png")));
        plot.add("distance", "m", TIMES);
        assertRefused("legal: a name that ends in .png or .svg", () -> plot.save(folder.resolve("a.jpg")));
        for (int i = 1; i < Plot.MAX_LINES; i++) {
            plot.add("line " + i, "m", TIMES);
        }
        assertRefused("legal: up to 16", () -> plot.add("more", "m", TIMES));
    }
}
