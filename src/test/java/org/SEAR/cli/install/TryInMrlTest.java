package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.jar.JarOutputStream;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.documents.DocBlock;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/**
 * {@code scripts/try-in-mrl} on a folder whose MyRobotLab is the embedded one: all scripts that come with SEAR run one after the other, again and
 * again, in one session, and print what each prints in a session of its own.
 */
public class TryInMrlTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", "."));
    /** A Java process for each script takes seconds, on a busy machine tens of them. */
    private static final int PATIENCE = 1200;
    private static final int ROUNDS = 3;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private Distribution distribution;
    private Path mrl;

    @Before
    public void layOut() throws IOException {
        distribution = new Distribution(folder.newFolder("distribution").toPath());
        mrl = folder.newFolder("my robot lab").toPath();
        distribution.layOut(mrl);
    }

    private Distribution.Result tried(String... scripts) throws Exception {
        List<String> page = DocBlock.commands("docs/embedded-and-real.md", "scripts/try-in-mrl");
        assertEquals(List.of("scripts/try-in-mrl /path/to/myrobotlab"), page);
        String script = page.get(0).substring(0, page.get(0).indexOf(' '));
        List<String> command = new ArrayList<>(List.of("python3", distribution.home().resolve(script).toString(), mrl.toString()));
        command.addAll(Arrays.asList(scripts));
        return Distribution.run(folder.getRoot().toPath(), folder.newFolder().toPath(), command, PATIENCE);
    }

    private static List<String> shippedScripts() throws IOException {
        List<String> names = new ArrayList<>();
        for (String where : new String[] {"scripts", "examples", "resources/resource"}) {
            try (Stream<Path> files = Files.walk(ROOT.resolve(where))) {
                files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(".py")).forEach(names::add);
            }
        }
        return names;
    }

    private List<String> tree() throws IOException {
        try (Stream<Path> paths = Files.walk(mrl)) {
            return paths.sorted().map(path -> mrl.relativize(path) + " " + path.toFile().length()).collect(Collectors.toList());
        }
    }

    @Test
    public void allScriptsInOneSessionPrintWhatEachPrintsAlone() throws Exception {
        List<String> before = tree();
        Distribution.Result result = tried();
        assertEquals(result.toString(), 0, result.status);
        List<String> names = shippedScripts();
        for (String name : names) {
            assertEquals(result + name, ROUNDS, result.out.lines().filter(("  " + name + ": the same")::equals).count());
        }
        assertTrue(result.toString(), result.out.contains("  listing06.py: 33 lines") && result.out.contains("  LIDAR.py: 1 lines"));
        assertTrue(result.toString(), result.out.endsWith(names.size() + " scripts, all outputs are the same; SEAR was taken out again.\n"));
        assertEquals(before, tree());
    }

    /** This MyRobotLab has a library of ours, so it is not installed, but nothing is in it. */
    @Test
    public void whatDiffersIsShownAndTheFolderIsAsItWas() throws Exception {
        new JarOutputStream(Files.newOutputStream(mrl.resolve("libraries/jar/vecmath-0.1.jar"))).close();
        List<String> before = tree();
        Distribution.Result result = tried("SEAR.py");
        assertEquals(result.toString(), 1, result.status);
        assertTrue(result.toString(), result.out.contains("  SEAR.py: differs\n") && result.out.contains("    -2.5"));
        assertTrue(result.toString(), result.out.contains("The last lines of MyRobotLab's log:"));
        assertTrue(result.toString(), result.out.endsWith("1 scripts, 3 outputs differ; SEAR was taken out again.\n"));
        assertEquals(before, tree());
    }

    @Test
    public void aFolderWithAProjectIsLeftAlone() throws Exception {
        Files.createDirectories(mrl.resolve("SEARproject"));
        Distribution.Result result = tried();
        assertEquals(result.toString(), 2, result.status);
        assertEquals("try-in-mrl: " + mrl.toRealPath().resolve("SEARproject") + " is there already, and would be lost. Take it out, or copy "
            + "MyRobotLab's folder and try in the copy.\n", result.err);
        Files.delete(mrl.resolve("SEARproject"));
        assertTrue(tried("nowhere.py").err.contains("there is no script nowhere.py; there are listing01.py, "));
    }
}
