// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.zip.CRC32;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.CameraImage;
import org.SEAR.sensors.PixelGrid;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Camera pictures in records: their number, the same bytes each time, and the handling of broken ones. */
public class RecordPicturesTest {
    private static final int WIDTH = 32;
    private static final int HEIGHT = 24;
    private static final int STEPS = 120;
    private static final int PIXEL = 12 * WIDTH + 16;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Path file(String name) {
        return project.getRoot().toPath().resolve(name);
    }

    private Project made() throws Exception {
        new Floor("floor", 20, 20);
        Box box = new Box("box", 2, 0.2, 1, 0);
        box.setTemperature(42);
        box.setColor("blue");
        box.move(0, 0.5, 3);
        SEARrobot robot = Robots.create("rover", "/dev/uart", "/dev/user");
        for (String kind : PictureKeeper.KINDS) {
            Camera camera = new Camera(kind, 0, 0.3, 0.2);
            camera.setKind(kind);
            camera.setSize(WIDTH, HEIGHT);
            robot.addComponent(camera);
        }
        return Project.read(project.folder());
    }

    /**
     * Drives towards the box for two seconds.
     * @return the pictures that one camera took, beginning with the present one at the start
     */
    private List<CameraImage> record(Project of, Path file, double rate, String camera) throws Exception {
        List<CameraImage> taken = new ArrayList<>();
        try (Simulation world = Simulation.of(of, 7)) {
            Recorder recorder = Recorder.begin(world, file, Recorder.LIMIT, rate, said -> { });
            world.post(DriveCommand.circle(0, 0.4, Double.POSITIVE_INFINITY));
            taken.add((CameraImage) world.read(camera));
            for (int i = 0; i < STEPS; i++) {
                world.step();
                CameraImage now = (CameraImage) world.read(camera);
                // before the first picture is due, each reading is of its own moment
                if (now.getTime() > 0.09 && now != taken.get(taken.size() - 1)) {
                    taken.add(now);
                }
            }
            recorder.end();
        }
        return taken;
    }

    @Test
    public void aRecordHasThePicturesThatWereTaken() throws Exception {
        Project of = made();
        List<CameraImage> taken = record(of, file("run.searlog"), 30, Camera.DEPTH);
        RecordPictures pictures = RecordPictures.of(RunRecord.open(file("run.searlog")));
        assertEquals(Set.copyOf(PictureKeeper.KINDS), pictures.cameras());
        assertEquals("one at the start and ten a second", 21, pictures.count(Camera.DEPTH));
        for (CameraImage image : taken) {
            RecordPictures.Place place = pictures.at(Camera.DEPTH, image.getTime() + 0.01);
            assertEquals(image.getTime(), place.time, 1e-9);
            PixelGrid grid = pictures.read(place);
            assertEquals(Camera.DEPTH, grid.getKind());
            assertEquals(WIDTH, grid.getWidth());
            assertEquals(HEIGHT, grid.getHeight());
            String words = grid.words(16, 12);
            assertTrue(words, words.matches("\\d\\.\\d{3} m ahead"));
            assertEquals("to a millimetre", image.getValues()[PIXEL], Double.parseDouble(words.split(" ")[0]), 0.6e-3);
            assertEquals("no return", grid.words(0, 0));
        }
        assertEquals("42.0 degC", pictures.read(pictures.at(Camera.INFRARED, 1)).words(16, 12));
        assertEquals("-20.0 degC", pictures.read(pictures.at(Camera.INFRARED, 1)).words(0, 0));
        String colour = pictures.read(pictures.at(Camera.COLOR, 1)).words(16, 12);
        assertTrue(colour, colour.matches("#[0-9a-f]{6}, about (blue|navy)"));
        assertNull("of another", pictures.at("other", 1));
        Frames frames = Frames.of(RunRecord.open(file("run.searlog")), 100);
        assertTrue(frames.whole);
        assertEquals("the three are told", 3, frames.pictured.size());
    }

    @Test
    public void asManyAsWereAskedForAreKeptAndNoneUnlessAskedFor() throws Exception {
        Project of = made();
        record(of, file("five.searlog"), 5, Camera.COLOR);
        record(of, file("none.searlog"), 0, Camera.COLOR);
        RecordPictures five = RecordPictures.of(RunRecord.open(file("five.searlog")));
        assertEquals(11, five.count(Camera.COLOR));
        assertEquals("every fifth of a second", 0.4, five.at(Camera.COLOR, 0.55).time, 1e-9);
        RecordPictures none = RecordPictures.of(RunRecord.open(file("none.searlog")));
        assertEquals(Set.of(), none.cameras());
        assertEquals(Set.of(), Frames.of(RunRecord.open(file("none.searlog")), 100).pictured);
    }

    @Test
    public void theSameRunGivesTheSameRecordAndRunsAgain() throws Exception {
        Project of = made();
        record(of, file("a.searlog"), 10, Camera.COLOR);
        record(of, file("b.searlog"), 10, Camera.COLOR);
        assertArrayEquals(Files.readAllBytes(file("a.searlog")), Files.readAllBytes(file("b.searlog")));
        assertTrue(Rerun.of(RunRecord.open(file("a.searlog")), of).same);
    }

    @Test
    public void itEndsAtItsLargestSizeWithPicturesToo() throws Exception {
        long limit = 60_000;
        try (Simulation world = Simulation.of(made(), 7)) {
            List<String> said = new ArrayList<>();
            Recorder recorder = Recorder.begin(world, file("run.searlog"), limit, 30, said::add);
            for (int i = 0; i < 10 * STEPS && said.isEmpty(); i++) {
                world.step();
            }
            recorder.end();
            assertTrue(said.toString(), said.toString().contains("it reached its maximum size"));
        }
        long size = Files.size(file("run.searlog"));
        assertTrue("a record of " + size + " bytes", size >= limit && size < limit + 30_000);
        assertTrue("it is whole", RunRecord.open(file("run.searlog")).read(new RunRecord.Visitor() { }));
    }

    /** Returns the offset of a record's first picture in its file. */
    private int firstPicture() throws IOException {
        long[] found = {-1};
        RunRecord.open(file("run.searlog")).read(new RunRecord.Visitor() {
            @Override
            public void picture(int sensor, String kind, double time, long offset, int length) {
                found[0] = found[0] < 0 ? offset : found[0];
            }
        });
        return (int) found[0];
    }

    @Test
    public void invalidPicturesAreRejectedAndTruncatedOnesSkipped() throws Exception {
        record(made(), file("run.searlog"), 10, Camera.COLOR);
        byte[] whole = Files.readAllBytes(file("run.searlog"));
        int at = firstPicture();
        int head = 2 + 1 + 8 + 4;
        refused(whole, at - 4, 0, "0 bytes, legal");
        refused(whole, at - 4, PictureKeeper.LONGEST_PICTURE + 1, "legal: 0 s to then, 1 to 8388608 bytes");
        refused(whole, at - head, 0x00630000, "sensor 99, legal: below 3");
        Files.write(file("run.searlog"), Arrays.copyOf(whole, at + 10));
        assertFalse("cut off in a picture", RunRecord.open(file("run.searlog")).read(new RunRecord.Visitor() { }));
        assertEquals(0, RecordPictures.of(RunRecord.open(file("run.searlog"))).count(Camera.COLOR));
        Random random = new Random(34);
        for (int i = 0; i < 200; i++) {
            byte[] broken = whole.clone();
            broken[at + random.nextInt(200)] = (byte) random.nextInt();
            Files.write(file("run.searlog"), broken);
            RecordPictures pictures = RecordPictures.of(RunRecord.open(file("run.searlog")));
            try {
                assertTrue(pictures.read(pictures.at(Camera.COLOR, 0)).getWidth() > 0);
            } catch (IOException e) {
                assertTrue(e.getMessage(), e.getMessage() != null);
            }
        }
    }

    /** A few bytes that claim gigabytes of memory. */
    @Test
    public void aPictureThatIsTooLargeIsRefusedBeforeItIsUnpacked() {
        ByteBuffer head = ByteBuffer.allocate(17).put("IHDR".getBytes(StandardCharsets.US_ASCII)).putInt(60_000)
            .putInt(60_000).putInt(0x10000000);
        CRC32 check = new CRC32();
        check.update(head.array());
        ByteBuffer file = ByteBuffer.allocate(33).putLong(0x89504e470d0a1a0aL).putInt(13).put(head.array())
            .putInt((int) check.getValue());
        String said = assertThrows(IOException.class, () -> PixelGrid.read(Camera.DEPTH, file.array())).getMessage();
        assertEquals("a picture has 3600000000 pixels, legal: at most " + Camera.MAX_PIXELS, said);
    }

    private void refused(byte[] whole, int at, int number, String words) throws IOException {
        byte[] broken = whole.clone();
        ByteBuffer.wrap(broken).putInt(at, number);
        Files.write(file("run.searlog"), broken);
        String said = assertThrows(IOException.class, () -> RecordPictures.of(RunRecord.open(file("run.searlog"))))
            .getMessage();
        assertTrue(said, said.contains(words));
    }
}
