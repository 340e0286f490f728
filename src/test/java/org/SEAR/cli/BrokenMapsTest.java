// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.RandomAccessFile;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Terrain;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.Progress;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.terrain.format.TiffMaker;
import org.junit.Rule;
import org.junit.Test;
import picocli.CommandLine;

/**
 * Messages of {@code sear check} and of the start for maps and aerial pictures that are broken, cut off or too large.
 */
public class BrokenMapsTest {
    private static final int SIDE = 40;
    /** Bytes per row of the map. */
    private static final int ROW = 2 * SIDE;
    private static final double STEP = 0.001;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private String said;

    private int check() {
        StringWriter all = new StringWriter();
        CommandLine line = SearCommand.commandLine().setOut(new PrintWriter(all)).setErr(new PrintWriter(all));
        int status = line.execute("check", project.folder().toString());
        said = all.toString();
        return status;
    }

    private void asset(String name, byte[] bytes) throws IOException {
        Path file = project.folder().resolve("assets").resolve(name);
        Files.createDirectories(file.getParent());
        Files.write(file, bytes);
    }

    private void asset(String name, String text) throws IOException {
        asset(name, text.getBytes(StandardCharsets.UTF_8));
    }

    private static TiffMaker map() {
        return TiffMaker.heights(SIDE, SIDE, 8, 47, STEP, new int[SIDE * SIDE]);
    }

    private static byte[] picture(String format) throws IOException {
        BufferedImage image = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
        Random random = new Random(1);
        for (int i = 0; i < 64 * 64; i++) {
            image.setRGB(i % 64, i / 64, random.nextInt(1 << 24));
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertTrue(ImageIO.write(image, format, out));
        return out.toByteArray();
    }

    private void refused(String image, byte[] bytes, String message) throws Exception {
        asset(image, bytes);
        Terrain ground = new Terrain("ground", "map.tif");
        ground.setImage(image);
        assertEquals(said, 2, check());
        String problem = "environment/ground.xml:11: image is \"" + image + "\", legal: a picture that "
            + "can be shown (" + message;
        assertTrue(problem + " in " + said, said.contains(problem));
        ProjectException refusal = assertThrows(ProjectException.class,
            () -> Simulation.load(project.folder(), 1).close());
        assertTrue(refusal.getMessage(), refusal.getMessage().contains(problem));
    }

    @Test
    public void aBrokenPictureOverTheTerrainIsRefusedByTheCheckAndTheStart() throws Exception {
        asset("map.tif", map().bytes());
        for (String format : new String[] {"png", "jpg", "gif"}) {
            byte[] whole = picture(format);
            refused("cut." + format, Arrays.copyOf(whole, whole.length * 3 / 4), "cut." + format
                + ": the picture is broken (its end is missing");
            asset("whole." + format, whole);
            new Terrain("ground", "map.tif").setImage("whole." + format);
            assertEquals(said, 0, check());
            assertTrue(said, !said.contains("warning: "));
        }
        byte[] changed = picture("png");
        changed[changed.length / 2] ^= 1;
        refused("changed.png", changed, "changed.png: the picture is broken (the checksum of its part at byte ");
        refused("text.png", "hello".getBytes(StandardCharsets.UTF_8), "text.png: the picture is in no known format, "
            + "legal: PNG, JPEG");
        refused("text.tif", "hello, this is a text".getBytes(StandardCharsets.UTF_8),
            "text.tif: the version of the TIFF is ");
        byte[] aerial = new TiffMaker(SIDE, SIDE, 8, new byte[SIDE * SIDE]).placed(8, 47, STEP)
            .with(273, 60000).bytes();
        refused("cut.tif", aerial, "cut.tif: strip 0 is 1600 bytes at 60000, legal: inside the file, which has ");
    }

    /** A picture of another place does not cover this terrain. */
    @Test
    public void aPictureOfAnotherPlaceIsRefused() throws Exception {
        asset("map.tif", map().bytes());
        byte[] elsewhere = new TiffMaker(SIDE, SIDE, 8, new byte[SIDE * SIDE]).placed(9, 47, STEP).bytes();
        refused("elsewhere.tif", elsewhere, "elsewhere.tif: the picture's place is about latitude 46.97950, "
            + "longitude 9.02050, legal: over the terrain");
    }

    /** A broken picture shared with a box, which alone would cause only a warning, is still an error. */
    @Test
    public void aBrokenPictureOfAnObjectIsAWarning() throws Exception {
        asset("map.tif", map().bytes());
        asset("text.png", "hello");
        new Box("box", 1, 1, 1).setImage("text.png");
        assertEquals(said, 0, check());
        assertTrue(said, said.contains("warning: environment/box.xml: the picture of Box \"box\" can't be "
            + "shown (text.png: "));
        refused("text.png", "hello".getBytes(StandardCharsets.UTF_8), "text.png: the picture is in no known format, "
            + "legal: PNG, JPEG");
    }

    @Test
    public void aMapTruncatedOutsideTheAreaIsReported() throws Exception {
        int[] offsets = new int[SIDE];
        int[] counts = new int[SIDE];
        for (int row = 0; row < SIDE; row++) {
            offsets[row] = row < SIDE * 3 / 4 ? 8 + row * ROW : 50_000 + row * ROW;
            counts[row] = ROW;
        }
        asset("map.tif", map().with(278, 1).with(273, offsets).with(279, counts).bytes());
        Terrain ground = new Terrain("ground", "map.tif");
        ground.setArea(46.99, 8.02, 500, 500);
        assertEquals(0, check());
        assertTrue(said, said.contains("warning: map.tif: the file is cut off: 10 of its 40 strips or tiles are "
            + "beyond its end"));
        ground.setArea(46.97, 8.02, 1000, 500);
        assertEquals(2, check());
        assertTrue(said, said.contains("map.tif: strip 30 is 80 bytes at 52400, legal: inside the file"));
    }

    /** The Eiffel Tower: longitude 2.2945, latitude 48.8584. */
    @Test
    public void aGridInLambert93LiesInFrance() throws Exception {
        asset("paris.asc", "ncols 3\nnrows 3\nxllcenter 648212\nyllcenter 6862246\ncellsize 25\n33 33 33\n33 35 "
            + "33\n33 33 33\n");
        asset("paris.prj", "PROJCS[\"RGF_1993_Lambert_93\",GEOGCS[\"GCS_RGF_1993\",DATUM[\"D_RGF_1993\","
            + "SPHEROID[\"GRS_1980\",6378137.0,"
            + "298.257222101]],PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]],"
            + "PROJECTION[\"Lambert_Conformal_Conic\"],"
            + "PARAMETER[\"False_Easting\",700000.0],PARAMETER[\"False_Northing\",6600000.0],"
            + "PARAMETER[\"Central_Meridian\",3.0],"
            + "PARAMETER[\"Standard_Parallel_1\",44.0],PARAMETER[\"Standard_Parallel_2\",49.0],"
            + "PARAMETER[\"Latitude_Of_Origin\",46.5],UNIT[\"Meter\",1.0]]");
        new Terrain("ground", "paris.asc");
        assertEquals(said, 0, check());
        Project read = Project.read(project.folder());
        assertEquals(48.8584, read.getOrigin().getLatitude(), 5e-5);
        assertEquals(2.2945, read.getOrigin().getLongitude(), 5e-5);
    }

    @Test
    public void fourMillionTilesAreRefusedByTheirNumber() throws Exception {
        int side = 2000;
        long[] offsets = new long[side * side];
        long[] counts = new long[side * side];
        Arrays.fill(offsets, 8);
        Arrays.fill(counts, 2);
        asset("tiles.tif", new TiffMaker(side, side, 16, (byte) 1, (byte) 0).placed(8, 47, 1e-4).with(273, null)
            .with(278, null).with(279, null).with(322, 1).with(323, 1).with(324, offsets).with(325, counts).bytes());
        new Terrain("ground", "tiles.tif");
        assertEquals(2, check());
        assertTrue(said, said.contains("tiles.tif: the number of strips or tiles in the area is 4000000, "
            + "legal: 1 to 100000"));
    }

    /**
     * Loading, importing and starting report all broken maps together, and the project stays unchanged. Data behind a
     * file's header are only read at the start.
     */
    @Test
    public void allBrokenMapsAreReportedTogether() throws Exception {
        asset("map.tif", map().bytes());
        asset("text.tif", "hello, this is a text");
        asset("short.asc", "ncols 3\nnrows 3\nxllcorner 8\nyllcorner 47\n1 2 3\n");
        asset("word.asc", "ncols 2\nnrows 2\nxllcorner 8\nyllcorner 47\ncellsize 0.001\n1 2 3 four\n");
        Terrain ground = new Terrain("ground", "map.tif");
        ground.addTile("text.tif");
        ground.addTile("short.asc");
        ground.addTile("word.asc");
        assertEquals(2, check());
        String start = said;
        Path mine = Files.createDirectories(project.getRoot().toPath().resolve("mine/environment")).resolve("box.xml");
        Files.writeString(mine, "<Box><name>box</name><length>1</length><width>1</width><height>1</height></Box>");
        Path other = mine.getParent().getParent();
        for (String told : new String[] {start,
            assertThrows(ProjectException.class, () -> Bundle.load(project.folder(), other)).getMessage(),
            assertThrows(ProjectException.class, () -> Bundle.importEnvironment(project.folder(), other, Progress.NONE))
                .getMessage()}) {
            for (String why : new String[] {"text.tif: the file is in no known format",
                "short.asc: cellsize is missing"}) {
                assertTrue(told, told.contains("tile is \"" + why.split(":")[0] + "\", legal: an elevation map that "
                    + "can be used (" + why));
            }
            assertTrue(told, !told.contains("word.asc"));
        }
        assertTrue(Files.exists(mine));
        new Terrain("ground", "word.asc");
        assertEquals(2, check());
        assertTrue(said, said.contains("path is \"word.asc\", legal: an elevation map that can be used (word.asc: "));
    }

    /** None of these gigabytes is read: the header or the first zero byte is enough to reject the file. */
    @Test
    public void gigabytesOfZerosAreRejectedByTheirHeader() throws Exception {
        asset("huge.asc", "ncols 4000\nnrows 4000\nxllcorner 8\nyllcorner 47\ncellsize 0.0001\n1 2 ");
        new Terrain("ground", "huge.asc");
        refusedWithLength(3L << 30, "huge.asc: the file's size is 3221225472, legal: 32000000 to 512065536 for "
            + "16000000 heights");
        refusedWithLength(400L << 20, "huge.asc: the character at byte 67 is 0, legal: text");
        asset("huge.asc", "");
        refusedWithLength(3L << 30, "huge.asc: the character at byte 0 is 0, legal: text");
    }

    private void refusedWithLength(long bytes, String message) throws IOException {
        try (RandomAccessFile file = new RandomAccessFile(project.folder().resolve("assets/huge.asc").toFile(), "rw")) {
            file.setLength(bytes);
        }
        assertEquals(2, check());
        assertTrue(said, said.contains(message));
    }
}
