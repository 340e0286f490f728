package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** What was built starts with the classes that the build has written down. */
public class ClassArchiveTest {
    private static final Path HOME = Path.of(System.getProperty("sear.classArchive")).getParent().getParent();
    private static final String SHARED = "source: shared objects file";

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();

    /** The classes of SEAR's own that are read for a command, each with where it came from. */
    private List<String> classes(Path home) throws Exception {
        Path log = folder.newFile().toPath();
        Path out = folder.newFile().toPath();
        ProcessBuilder builder = new ProcessBuilder(home.resolve("bin/sear").toString(), "--version");
        builder.redirectErrorStream(true).redirectOutput(out.toFile());
        builder.environment().put("JAVA_OPTS", "-XX:TieredStopAtLevel=1 -Xlog:class+load:file=" + log);
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        Process process = builder.start();
        assertTrue("sear hangs", process.waitFor(240, TimeUnit.SECONDS));
        assertEquals("nothing but its version is printed", 1, Files.readAllLines(out).size());
        try (Stream<String> lines = Files.lines(log)) {
            return lines.filter(line -> line.contains(" org.SEAR.cli.SearCommand ")).collect(Collectors.toList());
        }
    }

    @Test
    public void theLauncherTakesClassesFromTheArchive() throws Exception {
        List<String> classes = classes(HOME);
        assertEquals(classes.toString(), 1, classes.size());
        assertTrue(classes.toString(), classes.get(0).contains(SHARED));
    }

    /** Where the folder was copied to, or where the archive is broken, it starts without it and says nothing. */
    @Test
    public void anArchiveThatDoesNotFitIsPassedOver() throws Exception {
        Path copy = folder.newFolder("sear").toPath();
        for (String part : List.of("bin", "lib", "plugin")) {
            Files.createDirectories(copy.resolve(part));
            try (Stream<Path> files = Files.list(HOME.resolve(part))) {
                for (Path file : files.collect(Collectors.toList())) {
                    Files.copy(file, copy.resolve(part).resolve(file.getFileName()));
                }
            }
        }
        List<String> classes = classes(copy);
        assertTrue(classes.toString(), classes.size() == 1 && !classes.get(0).contains(SHARED));
        Path archive = copy.resolve("lib/sear.jsa");
        assertTrue(archive.toFile().setWritable(true));
        Files.write(archive, new byte[1000]);
        assertEquals(1, classes(copy).size());
    }
}
