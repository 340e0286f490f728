// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.SEAR.Slow;
import org.SEAR.terrain.tiff.MapBytes;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Tiles of SRTM, bare and zipped. */
@Category(Slow.class)
public class SrtmTileTest {
    private static final int SIDE = 1201;

    private static byte[] tile() {
        byte[] tile = new byte[2 * SIDE * SIDE];
        for (int i = 0; i < SIDE * SIDE; i++) {
            int height = i / SIDE - i % SIDE;
            tile[2 * i] = (byte) (height >> 8);
            tile[2 * i + 1] = (byte) height;
        }
        tile[2] = (byte) 0x80;
        tile[3] = 0;
        return tile;
    }

    private static byte[] zip(String name, byte[] content, String... before) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            for (String other : before) {
                zip.putNextEntry(new ZipEntry(other));
                zip.write(1);
            }
            zip.putNextEntry(new ZipEntry(name));
            zip.write(content);
        }
        return out.toByteArray();
    }

    private static SrtmTile open(String name, byte[] bytes) throws IOException {
        return SrtmTile.open(MapBytes.of(name, bytes));
    }

    private static void refused(String name, byte[] bytes, String message) {
        IOException e = assertThrows(message, IOException.class, () -> open(name, bytes));
        assertTrue(e.getMessage(), e.getMessage().startsWith(name + ": ") && e.getMessage().contains(message));
    }

    @Test
    public void theNameIsTheSouthWestCorner() throws IOException {
        SrtmTile tile = open("terrain/s33w071.SRTMGL3.hgt", tile());
        assertEquals(-71, tile.place.x(0, 0), 0);
        assertEquals(-32, tile.place.y(0, 0), 0);
        assertEquals(-70, tile.place.x(SIDE - 1, 0), 1e-12);
        assertEquals(-33, tile.place.y(0, SIDE - 1), 1e-12);
        float[] corner = tile.read(0, 0, 2, 3);
        assertTrue(Float.isNaN(corner[1]));
        assertEquals(-2, corner[2], 0);
        assertEquals(1, corner[3], 0);
        assertEquals(-1200 + 600, tile.read(600, 1200, 1, 1)[0], 0);
    }

    @Test
    public void zipped() throws IOException {
        SrtmTile tile = open("N36W085.hgt.zip", zip("N36W085.hgt", tile(), "readme.txt"));
        assertEquals(36, tile.place.y(0, SIDE - 1), 1e-12);
        assertEquals(7, tile.read(9, 2, 1, 1)[0], 0);
    }

    @Test
    public void invalidTilesAreRejected() throws IOException {
        refused("N36W085.hgt", new byte[1000], "the tile's size is 1000 bytes, legal: 2884802 (1201 x 1201 posts");
        refused("hills.hgt", tile(), "the file's name is hills.hgt, legal: the tile's south-west corner, such "
            + "as N36W085.hgt");
        refused("N95E000.hgt", tile(), "the latitude in the file's name is 95, legal: -90 to 89");
        refused("N36W085.hgt.zip", zip("readme.txt", new byte[9]), "no .hgt among the first 16 files");
        refused("N36W085.hgt.zip", Arrays.copyOf(zip("N36W085.hgt", tile()), 3000), "the zip is broken");
        refused("N36W085.hgt.zip", new byte[] {1, 2, 3, 4}, "no .hgt among the first 16 files");
    }

    @Test
    public void aZipThatUnpacksToMoreThanATileIsRefusedBeforeItIsUnpacked() throws IOException {
        refused("N36W085.hgt.zip", zip("N36W085.hgt", new byte[60_000_000]), "the size of N36W085.hgt in it is more "
            + "than 25934402 bytes");
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            zip.putNextEntry(new ZipEntry("bomb"));
            for (int i = 0; i < 80; i++) {
                zip.write(new byte[1 << 20]);
            }
            zip.putNextEntry(new ZipEntry("N36W085.hgt"));
        }
        refused("N36W085.hgt.zip", out.toByteArray(), "a file in the zip is more than 67108864 bytes");
    }
}
