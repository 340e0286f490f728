// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.Needs;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Programs for real network cameras read simulated ones. */
@Category(Slow.class)
@Needs("opencv")
public class ThirdPartyCameraTest extends WithPrograms {
    private static final int PICTURES = 5;
    /** Mean error of JPEG and its colours, of 255. */
    private static final double LOSS = 3;

    /** Makes a robot before a red box, with a camera and a depth camera. */
    @Before
    public void start() {
        room();
        Box red = new Box("red", 1, 0.2, 1, 0);
        red.setColor("red");
        red.move(0, 0.5, 2);
        SEARrobot robot = Robots.create2("rover");
        robot.addComponent(new Camera("eye", 0, 0.3, 0));
        Camera depth = new Camera("depth", 0, 0.3, 0);
        depth.setModel("Kinect");
        depth.setSize(160, 120);
        robot.addComponent(depth);
        simulate();
    }

    private static ProcessBuilder looking(String script, Object... arguments) {
        ProcessBuilder builder = python(script, arguments);
        builder.environment().put("PYTHONPATH", System.getProperty("sear.opencv"));
        return builder;
    }

    /** Returns the means of red, green and blue. */
    private double[] means() {
        int[] pixels = sear.getPixels("eye");
        double[] sums = new double[3];
        for (int rgb : pixels) {
            for (int i = 0; i < 3; i++) {
                sums[i] += (rgb >> 16 - 8 * i & 255) / (double) pixels.length;
            }
        }
        return sums;
    }

    /** @param first index of red, and the step from there to green and blue */
    private void assertSeen(List<String> output, int first, int step) {
        assertEquals(output.toString(), 2 + PICTURES, output.size());
        assertEquals("320 x 240", output.get(1));
        double[] expected = means();
        for (String line : output.subList(2, output.size())) {
            double[] seen = Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray();
            for (int i = 0; i < 3; i++) {
                assertEquals(output + " " + Arrays.toString(expected), expected[i], seen[first + step * i], LOSS);
            }
        }
    }

    private static String local(int port, String path) {
        return "http://localhost:" + port + path;
    }

    @Test
    public void opencvLooksThroughIt() throws Exception {
        int plain = sear.exportCamera("eye", 0);
        int esp32 = sear.exportCamera("eye", 0, "ESP32-CAM");
        int octoPi = sear.exportCamera("eye", 0, "OctoPi");
        for (String url : new String[] {local(plain, "/stream.mjpg"), local(esp32 + 1, "/stream"),
            local(octoPi, "/?action=stream")}) {
            List<String> output = programs.run(looking("opencv_stream.py", url, PICTURES), new ArrayList<>());
            assertTrue(output.toString(), output.get(0).matches("\\d+\\.\\d+.*"));
            assertSeen(output, 2, -1);
        }
    }

    @Test
    public void theProgramOfThePageLooks() throws Exception {
        String program = DocBlock.of("docs/cameras.md", "python3").get(0);
        assertTrue(program, program.contains("localhost:8081/"));
        Path file = folder.newFile("page.py").toPath();
        Files.writeString(file, program.replace("localhost:8081/", "localhost:" + sear.exportCamera("eye", 0) + "/"));
        List<String> output = programs.run(looking(file.toString()), new ArrayList<>());
        assertEquals(output.toString(), 10, output.size());
        assertTrue(output.toString(), output.get(9).startsWith("9 (240, 320, 3) mean of blue, green and red: ["));
    }

    @Test
    public void ffmpegReadsIt() throws Exception {
        int port = sear.exportCamera("eye", 0);
        assertSeen(programs.run(looking("ffmpeg_stream.py", local(port, "/stream.mjpg"), PICTURES), new ArrayList<>()),
            0, 1);
    }

    @Test
    public void opencvReadsDepths() throws Exception {
        int port = sear.exportCamera("depth", 0);
        List<String> output = programs.run(looking("opencv_depth.py", local(port, "/depth.png")), new ArrayList<>());
        assertEquals("uint16 160 x 120", output.get(0));
        assertEquals(1000 * sear.getDepth("depth")[60 * 160 + 80], Double.parseDouble(output.get(1)), 30);
        sear.stopExportCamera("depth");
        assertTrue(sear.getExports().isEmpty());
    }
}
