// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.TreeMap;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.regex.Pattern;
import org.SEAR.Fuzz;
import org.SEAR.POJOs.Model;
import org.SEAR.Slow;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.models.MutableModels;
import org.SEAR.project.problems.ProjectException;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Randomly changed bundles and models are opened or rejected with a message. {@link Fuzz} has their number and seed.
 */
@Category(Slow.class)
public class FuzzTest {
    private static final int[] ODD = {0, 1, 0x7f, 0x80, 0xff, '<', '"', '-', '9', 'e', '{', '\n'};

    /** Words of Java's exceptions, and characters that a terminal obeys. */
    private static final Pattern FOREIGN = Pattern.compile("Exception|Error\\b|\\bnull\\b|java\\.|gson|[Ii]ndex:? "
        + "-?\\d+|out of bounds|capacity|[Ll]ength \\d|"
        + "For input string|cannot be cast|enum constant|Cannot invoke|because \"|Negative|Unexpected "
        + "importer|[\\x00-\\x09\\x0b-\\x1f\\x7f-\\x9f]");

    @Rule
    public final ProjectRule project = new ProjectRule();
    private final Logger engine = Logger.getLogger("com.jme3");
    private Level level;

    @Before
    public void beQuiet() {
        level = engine.getLevel();
        engine.setLevel(Level.OFF);
    }

    @After
    public void beAsBefore() {
        engine.setLevel(level);
    }

    /**
     * Returns the bytes with one to eight changes: a changed byte, a run of equal bytes, or a part removed, doubled or
     * cut off.
     */
    private static byte[] mutated(byte[] original, Random random) {
        byte[] bytes = original.clone();
        for (int i = random.nextInt(8); i >= 0 && bytes.length > 1; i--) {
            int at = random.nextInt(bytes.length);
            int length = Math.min(bytes.length - at, 1 + random.nextInt(16));
            switch (random.nextInt(6)) {
                case 0:
                    bytes = spliced(bytes, at, at + length, at);
                    break;
                case 1:
                    bytes = spliced(bytes, at, at, at + length);
                    break;
                case 2:
                    bytes = random.nextInt(8) == 0 ? spliced(bytes, at, bytes.length, at) : bytes;
                    break;
                case 3:
                    Arrays.fill(bytes, at, at + length, (byte) ODD[random.nextInt(ODD.length)]);
                    break;
                default:
                    bytes[at] = random.nextBoolean() ? (byte) random.nextInt() : (byte) ODD[random.nextInt(ODD.length)];
            }
        }
        return bytes;
    }

    /**
     * Returns the bytes without those from {@code from} to {@code to}, and with those from {@code from} to {@code copy}
     * doubled.
     */
    private static byte[] spliced(byte[] bytes, int from, int to, int copy) {
        byte[] result = new byte[bytes.length - (to - from) + (copy - from)];
        System.arraycopy(bytes, 0, result, 0, from);
        System.arraycopy(bytes, from, result, from, copy - from);
        System.arraycopy(bytes, to, result, copy, bytes.length - to);
        return result;
    }

    @Test
    public void changedBundlesAreOpenedOrRefused() throws Exception {
        List<byte[]> originals = new ArrayList<>();
        for (String name : new String[] {"golden/version1-sensors.sear", "dissertation/macos-archive-utility.sear",
            "dissertation/folder-by-zip.sear", "dissertation/windows-powershell.sear"}) {
            originals.add(Bundle.class.getResourceAsStream(name).readAllBytes());
        }
        Random random = new Random(Fuzz.SEED);
        Path file = project.getRoot().toPath().resolve("fuzz.sear");
        int refused = 0;
        for (int i = 0; i < Fuzz.FILES; i++) {
            Files.write(file, mutated(originals.get(i % originals.size()), random));
            try {
                Bundle.check(file);
            } catch (ProjectException e) {
                assertTrue("seed " + Fuzz.SEED + ", bundle " + i + ": " + e.getMessage(), e.getMessage()
                    .contains("legal: "));
                refused++;
            }
        }
        assertTrue("refused " + refused, refused > Fuzz.FILES / 2);
    }

    @Test
    public void changedModelsAreLoadedOrRefused() throws Exception {
        TreeMap<String, byte[]> originals = MutableModels.all();
        List<String> endings = new ArrayList<>(originals.keySet());
        Random random = new Random(Fuzz.SEED);
        Path assets = Files.createDirectories(project.folder().resolve("assets"));
        project.put("environment/fuzz.xml",
            "<Box><name>fuzz</name><length>1</length><width>1</width><height>1</height></Box>");
        for (String ending : endings) {
            Files.write(assets.resolve("m" + ending), originals.get(ending));
            assertTrue(MutableModels.load(project.folder(), new Model("m", "m" + ending)).size() > 0);
        }
        int refused = 0;
        for (int i = 0; i < Fuzz.FILES; i++) {
            String ending = endings.get(i % endings.size());
            byte[] bytes = mutated(originals.get(ending), random);
            Files.write(assets.resolve("m" + ending), bytes);
            try {
                MutableModels.load(project.folder(), new Model("m" + i, "m" + ending));
            } catch (IOException e) {
                assertTrue(text(i, ending, bytes) + e.getMessage(), e.getMessage().contains("Model \"m"));
                boolean own = !FOREIGN.matcher(e.getMessage().replaceAll("is .{1,90}, legal", "")).find();
                assertTrue(text(i, ending, bytes) + e.getMessage(), own && e.getMessage().contains(", legal: "));
                refused++;
            } catch (RuntimeException | Error e) {
                throw new AssertionError(text(i, ending, bytes), e);
            }
            Files.deleteIfExists(project.folder().resolve("environment/m" + i + ".xml"));
        }
        assertTrue("refused " + refused, refused > Fuzz.FILES / 10);
    }

    private static String text(int number, String ending, byte[] bytes) {
        return "seed " + Fuzz.SEED + ", model " + number + ending + ": "
            + new String(bytes, StandardCharsets.ISO_8859_1) + "\n";
    }
}
