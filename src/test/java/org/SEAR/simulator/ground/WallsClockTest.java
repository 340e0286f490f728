// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ground;

import static org.junit.Assert.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.File;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.util.Random;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.FloorPlan;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** A large map loads in seconds. */
public class WallsClockTest {
    private static final int SIDE = 2000;
    /** Processor time, seconds; 2 s of a processor that nothing else uses, with the optimising compiler. */
    private static final double MOST = 6;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void aMapOfFourMillionPixelsLoadsInSeconds() throws Exception {
        BufferedImage picture = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_BYTE_GRAY);
        Graphics2D pen = picture.createGraphics();
        pen.setColor(Color.WHITE);
        pen.fillRect(0, 0, SIDE, SIDE);
        pen.setColor(Color.BLACK);
        Random random = new Random(3);
        for (int i = 0; i < 2000; i++) {
            int x = random.nextInt(SIDE);
            int y = random.nextInt(SIDE);
            pen.drawLine(x, y, x + random.nextInt(100) - 50, y + random.nextInt(100) - 50);
        }
        File file = Files.createDirectories(project.folder().resolve("assets")).resolve("map.png").toFile();
        ImageIO.write(picture, "png", file);
        new FloorPlan("map", "map.png", 0.05, 1);
        long from = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        Worlds.start(project).close();
        double seconds = (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - from) / 1e9;
        assertTrue(seconds + " s", seconds < MOST);
    }
}
