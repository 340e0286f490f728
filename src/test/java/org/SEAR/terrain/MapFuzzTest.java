// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import javax.imageio.ImageIO;
import org.SEAR.HowMany;
import org.SEAR.Slow;
import org.SEAR.files.Assets;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.terrain.format.TiffMaker;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** Files with changed, removed and doubled bytes are either read or rejected with a message. */
@Category(Slow.class)
public class MapFuzzTest {
    private static final int TRIES = HowMany.of("sear.fuzzMaps", 300);
    private static final Path REAL = Paths.get(System.getProperty("sear.root", "."),
        "src/test/resources/org/SEAR/terrain");

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private final Random random = new Random(19);

    private static Map<String, byte[]> files() throws IOException {
        Map<String, byte[]> files = new LinkedHashMap<>();
        int[] heights = new int[30 * 20];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = i;
        }
        TiffMaker small = TiffMaker.heights(30, 20, 8, 47, 0.001, heights);
        files.put("small.tif", small.with(42113, "-9999").bytes());
        files.put("big-endian.tif", small.bigEndian().bytes());
        files.put("utm.tif", Files.readAllBytes(REAL.resolve("jacksboro-utm16n.tif")));
        files.put("grid.asc", ("ncols 4\nnrows 3\nxllcorner 8\nyllcorner 47\ncellsize 0.001\nNODATA_value -9999\n"
            + "1 2 3 4\n5 6.5 7 8\n9 10 11 12\n").getBytes(StandardCharsets.US_ASCII));
        files.put("colours.tif", new TiffMaker(20, 10, 8, new byte[600]).with(277, 3).with(258, new int[] {8, 8, 8})
            .with(262, 2).placed(8, 47, 0.001).bytes());
        ByteArrayOutputStream zipped = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(zipped)) {
            zip.putNextEntry(new ZipEntry("N36W085.hgt"));
            zip.write(new byte[2 * 1201 * 1201]);
        }
        files.put("N36W085.hgt.zip", zipped.toByteArray());
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(20, 30, BufferedImage.TYPE_USHORT_GRAY), "png", png);
        files.put("grey.png", png.toByteArray());
        return files;
    }

    /** Returns small parts of large maps, which load quickly. */
    private static TerrainArea area(String name) {
        TerrainArea all = TerrainArea.of(name, Collections.emptyList());
        return name.equals("utm.tif") || name.endsWith(".zip") ? all.around(36.55, -84.25, 2000, 2000)
            : name.equals("grey.png") ? all.sized(100, 100, 0, 10) : all;
    }

    private byte[] changed(byte[] whole) {
        byte[] bytes = whole.clone();
        // the tables of a TIFF and the header of a grid are at either end
        int reach = random.nextBoolean() ? bytes.length : Math.min(bytes.length, 600);
        for (int i = random.nextInt(4); i >= 0; i--) {
            int at = random.nextBoolean() ? random.nextInt(reach) : bytes.length - 1 - random.nextInt(reach);
            bytes[at] = random.nextInt(3) == 0 ? (byte) (random.nextBoolean() ? 0xff : 0) : (byte) random.nextInt();
        }
        return random.nextInt(5) == 0 ? Arrays.copyOf(bytes, random.nextInt(bytes.length)) : bytes;
    }

    @Test
    public void anyFileIsReadOrRejected() throws IOException {
        Assets assets = new Assets(folder.getRoot().toPath());
        int read = 0;
        List<String> refused = new ArrayList<>();
        for (Map.Entry<String, byte[]> file : files().entrySet()) {
            for (int i = 0; i < (file.getValue().length > 2000 ? TRIES / 10 : TRIES); i++) {
                Files.write(folder.getRoot().toPath().resolve(file.getKey()), changed(file.getValue()));
                try {
                    if (file.getKey().startsWith("colours")) {
                        AerialPicture.load(assets, file.getKey(), new GeoOrigin(46.995, 0, 8.01), -300, 300, -300, 300);
                    } else {
                        TerrainLoader.load(area(file.getKey()), assets);
                    }
                    read++;
                } catch (IOException e) {
                    assertTrue(e.toString(), e.getMessage().startsWith(file.getKey() + ": "));
                    refused.add(e.getMessage());
                }
            }
        }
        assertTrue(read + " read", read > 100);
        assertTrue(refused.size() + " refused", refused.size() > 100);
    }
}
