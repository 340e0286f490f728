// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import org.SEAR.Slow;
import org.SEAR.files.Assets;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.terrain.format.TiffMaker;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** Aerial pictures with their own georeference. */
@Category(Slow.class)
public class AerialPictureTest {
    private static final int[] UTM = {1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 32632};

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private Assets assets;

    @Before
    public void assets() {
        assets = new Assets(folder.getRoot().toPath());
    }

    /**
     * Makes a picture in which red grows to the east and green to the south, on the central meridian of UTM 32, where
     * grid north is true north.
     */
    private static TiffMaker picture(int side, int samples) {
        byte[] pixels = new byte[side * side * samples];
        for (int i = 0; i < side * side; i++) {
            pixels[i * samples] = (byte) (i % side * 256 / side);
            pixels[i * samples + (samples > 1 ? 1 : 0)] = (byte) (i / side * 256 / side);
        }
        return new TiffMaker(side, side, 8, pixels).with(277, samples).with(262, samples > 1 ? 2 : 1)
            .with(258, samples > 1 ? new int[] {8, 8, 8} : new int[] {8}).placed(500000 - side, 5_200_000 + side, 2)
            .with(34735, UTM);
    }

    private static GeoOrigin origin() throws IOException {
        double[] place = MapSystem.at("map", "EPSG:32632", 47, 9).toEarth(500000, 5_200_000);
        return new GeoOrigin(place[0], 400, place[1]);
    }

    private AerialPicture load(TiffMaker picture, double... rectangle) throws IOException {
        Files.write(folder.getRoot().toPath().resolve("aerial.tif"), picture.bytes());
        return AerialPicture.load(assets, "aerial.tif", origin(), rectangle);
    }

    @Test
    public void coloursLieWhereTheyLieOnEarth() throws IOException {
        AerialPicture picture = load(picture(256, 3), -100, 100, -50, 50);
        assertTrue(picture.rows + " x " + picture.columns, picture.rows >= 100 && picture.rows <= 106
            && picture.columns >= 50);
        for (int row = 0; row < picture.rows; row += 7) {
            for (int column = 0; column < picture.columns; column += 7) {
                double x = picture.north - (row + 0.5) * (picture.north - picture.south) / picture.rows;
                double z = picture.west + (column + 0.5) * (picture.east - picture.west) / picture.columns;
                int colour = picture.colours[row * picture.columns + column];
                assertEquals(0xff, colour >>> 24);
                assertEquals(128 + z / 2 - 0.5, colour >> 16 & 0xff, 1.1);
                assertEquals(128 - x / 2 - 0.5, colour >> 8 & 0xff, 1.1);
            }
        }
    }

    @Test
    public void beyondThePictureNothingIsSeen() throws IOException {
        AerialPicture picture = load(picture(64, 3), -200, 200, -200, 200);
        assertEquals(0, picture.colours[0]);
        int middle = picture.colours[picture.rows / 2 * picture.columns + picture.columns / 2];
        assertEquals(0xff, middle >>> 24);
    }

    @Test
    public void aLargePictureIsMadeSmallerByMeans() throws IOException {
        AerialPicture picture = load(picture(5000, 1), -4900, 4900, -4900, 4900);
        assertTrue(picture.rows <= AerialPicture.MAX_SIDE && picture.rows > 2000);
        int colour = picture.colours[picture.rows / 4 * picture.columns + picture.columns / 2];
        assertEquals(64, colour & 0xff, 3);
        assertEquals(colour & 0xff, colour >> 16 & 0xff);
    }

    @Test
    public void invalidInputIsReported() {
        String place = "aerial.tif: the place on Earth is not known, legal: a GeoTIFF with a coordinate system";
        refused(picture(8, 3).with(33550, null).with(33922, null), place);
        refused(picture(8, 3).with(34735, null), place);
        refused(picture(8, 3).with(262, 3), "aerial.tif: PhotometricInterpretation is 3, legal: 0, 1 (grey) or 2");
        refused(picture(8, 3).with(258, new int[] {16, 16, 16}), "aerial.tif: the pixels is 3 values of 16 bits, "
            + "legal: 1 to 4 values of 8 bits");
        refused(picture(8, 3).with(259, 7), "aerial.tif: Compression is 7 (JPEG)");
        refused(picture(8, 3).placed(500000, 5_300_000, 2).with(34735, UTM), "aerial.tif: the picture's place is about "
            + "latitude 47.8");
    }

    private void refused(TiffMaker picture, String message) {
        IOException e = assertThrows(message, IOException.class, () -> load(picture, -100, 100, -100, 100));
        assertTrue(e.getMessage(), e.getMessage().startsWith(message));
    }
}
