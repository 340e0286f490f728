// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.SEAR.Needs;

/** The distribution starts with the classes of the archive that the build made. */
@Needs("classArchive")
public class ClassArchiveTest {
    private static final Path HOME = Path.of(System.getProperty("sear.classArchive")).getParent().getParent();
    private static final String SHARED = "source: shared objects file";
    /**
     * Largest number of classes loaded from elsewhere: about 60 of 5000 on Java 17. Java 25 cannot archive classes of
     * the format before Java 6, such as all of Jython's, which makes 1400.
     */
    private static final int MOST_OTHERS = Runtime.version().feature() == 17 ? 150 : 2000;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();

    /** Returns the classes loaded for a command, each with its source. */
    private List<String> classes(Path home, String... arguments) throws Exception {
        Path log = folder.newFile().toPath();
        Path out = folder.newFile().toPath();
        List<String> command = new ArrayList<>(List.of(home.resolve("bin/sear").toString()));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command);
        builder.directory(folder.getRoot()).redirectErrorStream(true).redirectOutput(out.toFile());
        builder.environment().put("JAVA_OPTS", "-XX:TieredStopAtLevel=1 -Xlog:class+load:file=" + log);
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        builder.environment().put("XDG_CACHE_HOME", folder.getRoot().toPath().resolve("cache").toString());
        Process process = builder.start();
        assertTrue("sear hangs", process.waitFor(240, TimeUnit.SECONDS));
        assertEquals("nothing but one line is printed", 1, Files.readAllLines(out).size());
        return Files.readAllLines(log);
    }

    private List<String> command(Path home) throws Exception {
        return classes(home, "--version").stream().filter(line -> line.contains(" org.SEAR.cli.SearCommand "))
            .collect(Collectors.toList());
    }

    @Test
    public void theLauncherTakesClassesFromTheArchive() throws Exception {
        List<String> classes = command(HOME);
        assertEquals(classes.toString(), 1, classes.size());
        assertTrue(classes.toString(), classes.get(0).contains(SHARED));
    }

    /** From the start to a first reading, next to no class comes from outside the archive. */
    @Test
    public void aScriptBeginsWithClassesFromTheArchive() throws Exception {
        Path script = folder.newFile("first.py").toPath();
        Files.writeString(script, "from org.SEAR.POJOs import *\nsear = Runtime.start('sear', "
            + "'SEAR')\nFloor('floor', 10, 10)\n"
            + "robot = Robots.create('first', '/dev/user', '/dev/uart')\nrobot.addComponent(LIDAR('scanner', 8, 180, "
            + "0.5, 0, 0.15, 0.1))\nsear.startSimulation()\nprint 'beams: %d' % len(sear.getLidarResult('scanner'))\n");
        List<String> classes = classes(HOME, script.toString(), "--headless", "--speed", "max", "--port", "none");
        assertTrue("a script reads " + classes.size() + " classes", classes.size() > MOST_OTHERS);
        List<String> others = classes.stream().filter(line -> !line.contains(SHARED)).collect(Collectors.toList());
        assertTrue(others.size() + " of them are not in the archive:\n" + String.join("\n", others),
            others.size() <= MOST_OTHERS);
        assertEquals("what asks for the names of all time zones", List.of(),
            classes.stream().filter(line -> line.contains(" com.thoughtworks.xstream.core.JVM "))
                .collect(Collectors.toList()));
    }

    /** A copy gets an archive in the user's cache by its second simulation; a broken one is ignored. */
    @Test
    public void aCopyHasAnArchiveInTheCache() throws Exception {
        Path copy = folder.newFolder("sear").toPath();
        for (String part : List.of("bin", "lib", "plugin")) {
            Files.createDirectories(copy.resolve(part));
            try (Stream<Path> files = Files.list(HOME.resolve(part))) {
                for (Path file : files.collect(Collectors.toList())) {
                    Files.copy(file, copy.resolve(part).resolve(file.getFileName()));
                }
            }
        }
        Path script = folder.newFile("short.py").toPath();
        Files.writeString(script, "print 'short'    # without sear.startSimulation()\n");
        for (int i = 0; i < 2; i++) {
            assertFalse("start " + i, command(copy).get(0).contains(SHARED));
            classes(copy, script.toString(), "--headless", "--port", "none");
        }
        assertTrue(command(copy).get(0).contains(SHARED));
        try (Stream<Path> files = Files.walk(folder.getRoot().toPath().resolve("cache"))) {
            Path archive = files.filter(file -> file.endsWith("sear.jsa")).findAny().orElseThrow();
            assertTrue(archive.toFile().setWritable(true));
            Files.write(archive, new byte[1000]);
        }
        assertFalse(command(copy).get(0).contains(SHARED));
    }
}
