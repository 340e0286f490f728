// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Collections;
import org.SEAR.ProcessorTime;
import org.SEAR.Slow;
import org.SEAR.files.Assets;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** A tile of 3601 x 3601 samples loads in less than 3 s of one core and takes less than 16 bytes per sample. */
@Category(Slow.class)
public class MapLoadingClockTest {
    private static final int SIDE = 3601;
    private static final double SECONDS = 3;
    private static final int BYTES = 16;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();

    private static byte[] tile() {
        byte[] tile = new byte[2 * SIDE * SIDE];
        for (int i = 0; i < SIDE * SIDE; i++) {
            int height = (int) (1000 + 500 * Math.sin(i % SIDE / 90.0) * Math.cos(i / SIDE / 70.0));
            tile[2 * i] = (byte) (height >> 8);
            tile[2 * i + 1] = (byte) height;
        }
        return tile;
    }

    private static long used() {
        System.gc();
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }

    @Test
    public void aTileOfOneArcSecond() throws IOException {
        Files.write(folder.getRoot().toPath().resolve("N46E007.hgt"), tile());
        Assets assets = new Assets(folder.getRoot().toPath());
        long before = used();
        ProcessorTime time = new ProcessorTime();
        Ground ground = TerrainLoader.load(TerrainArea.of("N46E007.hgt", Collections.emptyList()), assets);
        double seconds = time.seconds();
        ground.field.getPyramid();
        double bytes = (used() - before) / (double) ground.field.heights.length;
        System.out.printf("%d x %d posts: %.2f s, %.1f bytes each%n", ground.field.rows, ground.field.columns,
            seconds, bytes);
        assertTrue(ground.field.heights.length > 12_500_000);
        assertTrue(seconds + " s", seconds < SECONDS);
        assertTrue(bytes + " bytes", bytes < BYTES);
        int column = 1234;
        int row = 2345;
        double wanted = (int) (1000 + 500 * Math.sin(column / 90.0) * Math.cos(row / 70.0));
        assertEquals(wanted, ground.height(47 - row / 3600.0, 7 + column / 3600.0), 0.001);
    }
}
