// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Panels are installed where MyRobotLab serves them, and files that the user changed stay. */
public class PanelFilesTest {
    private static final String SCRIPT = "WebGui/app/service/js/LIDARGui.js";
    private static final String RECORD = ".sear-files.properties";

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private Path root() {
        return temporary.getRoot().toPath();
    }

    private String installed() throws IOException {
        PanelFiles.install(root());
        return Files.readString(root().resolve(SCRIPT));
    }

    @Test
    public void missingFilesAreWritten() throws IOException {
        assertTrue(installed().contains("LIDARGui"));
        assertTrue(Files.exists(root().resolve("WebGui/app/service/views/LIDARGui.html")));
        assertTrue(Files.readString(root().resolve("LIDAR/LIDAR.py")).contains("singleScan"));
    }

    @Test
    public void everyExampleProjectIsOfferedInTheTab() throws IOException {
        PanelFiles.install(root());
        try (DirectoryStream<Path> examples = Files.newDirectoryStream(
            Paths.get(System.getProperty("sear.root", "."), "examples"), "*.sear")) {
            for (Path example : examples) {
                assertArrayEquals(Files.readAllBytes(example),
                    Files.readAllBytes(root().resolve("SEAR").resolve(example.getFileName())));
            }
        }
    }

    /** The installed panels have all files of the jar. */
    @Test
    public void everyFileOfThePanelsIsInstalled() throws IOException {
        PanelFiles.install(root());
        Path ours = Paths.get(System.getProperty("sear.root", "."), "resources/resource");
        try (Stream<Path> files = Files.walk(ours)) {
            for (Path file : files.filter(Files::isRegularFile).collect(Collectors.toList())) {
                Path installed = root().resolve(ours.relativize(file));
                assertTrue(installed + " is missing", Files.exists(installed));
                assertArrayEquals(Files.readAllBytes(file), Files.readAllBytes(installed));
            }
        }
    }

    @Test
    public void iconsAreSixteenPixels() throws IOException {
        installed();
        BufferedImage icon = ImageIO.read(root().resolve("LIDAR.png").toFile());
        assertEquals(16, icon.getWidth());
        assertEquals(16, icon.getHeight());
    }

    @Test
    public void filesOfAnOlderVersionAreReplaced() throws IOException {
        String ours = installed();
        Files.writeString(root().resolve(SCRIPT), "older");
        Files.writeString(root().resolve(RECORD), SCRIPT + "=" + sha256("older") + "\n");
        assertEquals(ours, installed());
    }

    @Test
    public void obsoleteFilesAreDeletedUnlessTheUserChangedThem() throws IOException {
        installed();
        Files.writeString(root().resolve("WebGui/older.js"), "older");
        Files.writeString(root().resolve("WebGui/changed.js"), "mine");
        Files.writeString(root().resolve(RECORD), "WebGui/older.js=" + sha256("older") + "\nWebGui/changed.js="
            + sha256("older") + "\n");
        installed();
        assertFalse(Files.exists(root().resolve("WebGui/older.js")));
        assertEquals("mine", Files.readString(root().resolve("WebGui/changed.js")));
        assertFalse(Files.readString(root().resolve(RECORD)).contains("WebGui/changed.js"));
    }

    @Test
    public void changesOfTheUserStay() throws IOException {
        installed();
        Files.writeString(root().resolve(SCRIPT), "mine");
        assertEquals("mine", installed());
    }

    @Test
    public void withoutMyRobotLabsResourcesNothingIsMade() throws IOException {
        Path missing = root().resolve("resource");
        PanelFiles.install(missing);
        assertFalse(Files.exists(missing));
    }

    private static String sha256(String text) {
        try {
            StringBuilder hex = new StringBuilder();
            for (byte b : java.security.MessageDigest.getInstance("SHA-256")
                .digest(text.getBytes(java.nio.charset.StandardCharsets.UTF_8))) {
                hex.append(String.format("%02x", b));
            }
            return hex.toString();
        } catch (java.security.NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
