// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.After;
import org.junit.Test;

/** Install, update and removal in a real MyRobotLab: afterwards its folder is the same to the byte. */
public class InstallTest {
    private static final Path OLDER = RealMrlCopy.BUILD.resolve("older-sear");

    @After
    public void deleteCopies() throws IOException {
        RealMrlCopy.delete(RealMrlCopy.BUILD.resolve("installed"));
        RealMrlCopy.delete(OLDER);
    }

    /**
     * Returns length and checksum of each file by path; folder names end in '/'. CRC is used because a hash costs 10 s
     * more CPU time without the optimizing compiler.
     */
    private static Map<String, List<Long>> bytes(Path folder) throws IOException {
        Map<String, List<Long>> bytes = new TreeMap<>();
        for (Path path : RealMrlCopy.tree(folder)) {
            String name = folder.relativize(path).toString();
            if (Files.isDirectory(path)) {
                bytes.put(name + "/", List.of());
            } else {
                byte[] content = Files.readAllBytes(path);
                CRC32 sum = new CRC32();
                sum.update(content);
                bytes.put(name, List.of((long) content.length, sum.getValue()));
            }
        }
        return bytes;
    }

    /**
     * Makes a distribution of an older SEAR: a different plug-in jar, and a library that the current version does not
     * ship.
     */
    private static void makeOlder() throws IOException {
        RealMrlCopy.delete(OLDER);
        RealMrlCopy.copy(RealMrlCopy.SEAR.getParent().getParent(), OLDER);
        Path plugin = OLDER.resolve("plugin/sear.jar");
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.IMPLEMENTATION_VERSION, "0.9.0");
        try (ZipFile today = new ZipFile(RealMrlCopy.SEAR.resolveSibling("../plugin/sear.jar").toFile());
                JarOutputStream jar = new JarOutputStream(Files.newOutputStream(plugin), manifest)) {
            for (ZipEntry entry : Collections.list(today.entries())) {
                if (!entry.isDirectory() && !entry.getName().equals(JarFile.MANIFEST_NAME)) {
                    jar.putNextEntry(new ZipEntry(entry.getName()));
                    today.getInputStream(entry).transferTo(jar);
                    jar.closeEntry();
                }
            }
        }
        Files.copy(plugin, OLDER.resolve("plugin/sear-old-library-1.0.jar"));
    }

    @Test
    public void aMyRobotLabThatWasNeverStartedIsUnchangedAfterRemoval() throws Exception {
        RealMrlCopy copy = new RealMrlCopy("installed");
        assertItIsAsItWas(copy.folder());
    }

    /** Includes the files that MyRobotLab and SEAR's panels have written since. */
    @Test
    public void aMyRobotLabThatHasRunIsUnchangedAfterRemoval() throws Exception {
        Path running = RealMrl.shared().folder();
        Path folder = new RealMrlCopy("installed").folder();
        RealMrlCopy.delete(folder);
        Files.createDirectories(folder);
        Files.copy(running.resolve("myrobotlab.jar"), folder.resolve("myrobotlab.jar"));
        for (String part : new String[] {"libraries", "resource"}) {
            RealMrlCopy.copy(running.resolve(part), folder.resolve(part));
        }
        RealMrlCopy.install(RealMrlCopy.SEAR, folder, "--remove");
        List<String> left = bytes(folder).keySet().stream()
            .filter(name -> name.matches("(.*/)?(SEAR|LIDAR|GPS)[^/]*/?")).collect(Collectors.toList());
        assertEquals("of SEAR", List.of(), left);
        assertItIsAsItWas(folder);
    }

    private static void assertItIsAsItWas(Path folder) throws Exception {
        Map<String, List<Long>> before = bytes(folder);
        RealMrlCopy.install(RealMrlCopy.SEAR, folder);
        Map<String, List<Long>> installed = bytes(folder);
        RealMrlCopy.install(RealMrlCopy.SEAR, folder);
        assertEquals("installed again", installed, bytes(folder));
        RealMrlCopy.install(RealMrlCopy.SEAR, folder, "--remove");
        assertEquals("removed", before, bytes(folder));
        makeOlder();
        RealMrlCopy.install(OLDER.resolve("bin/sear"), folder);
        assertTrue(Files.exists(folder.resolve("libraries/jar/sear-old-library-1.0.jar")));
        assertNotEquals(installed, bytes(folder));
        RealMrlCopy.install(RealMrlCopy.SEAR, folder);
        assertEquals("updated", installed, bytes(folder));
        RealMrlCopy.install(RealMrlCopy.SEAR, folder, "--remove");
        assertEquals("removed after the update", before, bytes(folder));
    }
}
