// SPDX-License-Identifier: Apache-2.0
package org.SEAR.learning;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.Needs;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/**
 * The environments of {@code sear.gym} in Python 3 with Gymnasium: scripts of src/test/gymnasium and programs of
 * docs/learning.md.
 */
@Category(Slow.class)
@Needs({"installDist", "python3", "gymnasium"})
public class GymnasiumTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final Path SCRIPTS = ROOT.resolve("src/test/gymnasium");
    private static final long PATIENCE_SECONDS = 600;
    private static final String PACKAGES = ROOT.resolve("python/src") + File.pathSeparator
        + System.getProperty("sear.python3");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    /** Returns the output of a program, which must end with this status. */
    private String run(int status, String packages, Path program, String... arguments)
        throws IOException, InterruptedException {
        Path output = folder.newFile().toPath();
        List<String> command = new java.util.ArrayList<>(List.of("python3", program.toString()));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.getRoot()).redirectErrorStream(true)
            .redirectOutput(output.toFile());
        builder.environment().put("PYTHONPATH", packages);
        Process process = builder.start();
        boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        String text = Files.readString(output, StandardCharsets.UTF_8);
        assertTrue("it has not ended:\n" + text, ended);
        assertEquals(text, status, process.exitValue());
        return text;
    }

    private static String gymnasium() {
        return PACKAGES + File.pathSeparator + System.getProperty("sear.gymnasium");
    }

    private String script(String name) throws IOException, InterruptedException {
        return run(0, gymnasium(), SCRIPTS.resolve(name));
    }

    @Test
    public void gymnasiumFindsNothingWrongWithTheFour() throws Exception {
        assertEquals("Maze checked\nWallFollow checked\nLineFollow checked\nDocking checked\n", script("checked.py"));
    }

    @Test
    public void aSeedGivesTheSameEpisodeToTheBitInEachProcess() throws Exception {
        String first = script("same.py");
        assertTrue(first, first.contains("episode "));
        assertEquals(first.substring(first.indexOf("episode ")), second(first));
    }

    private String second(String first) throws Exception {
        String second = script("same.py");
        return second.substring(second.indexOf("episode "));
    }

    @Test
    public void worldsAreSideBySideHereAndInProcessesOfTheirOwn() throws Exception {
        String text = script("worlds.py");
        assertTrue(text, text.contains("four worlds here, two elsewhere"));
        assertTrue(text, text.contains("forked ones end"));
        assertTrue(text, text.contains("use the start method \"spawn\", for example gymnasium.make_vec(..., "
            + "vectorization_mode=\"async\", vector_kwargs={\"context\": \"spawn\"})"));
    }

    @Test
    public void illegalArgumentsAreReported() throws Exception {
        assertEquals("all refused\n", script("refused.py"));
    }

    @Test
    public void camerasArePicturesAndGpsReceiversMetres() throws Exception {
        assertTrue(script("pictures.py").endsWith("pictures and metres\n"));
    }

    @Test
    public void steeringServosAndMotorsAreActions() throws Exception {
        assertTrue(script("controls.py").endsWith("controls\n"));
    }

    @Test
    public void rewardsGetTheirArguments() throws Exception {
        assertEquals("rewards as they are to be\n", script("rewards.py"));
    }

    @Test
    public void policiesByHandAreBetterThanChance() throws Exception {
        String text = script("policies.py");
        assertTrue(text, text.contains("WallFollow by hand ") && text.contains("LineFollow by hand ")
            && text.contains("Docking by hand "));
    }

    /** The package itself works without Gymnasium; only the import of sear.gym reports that it is missing. */
    @Test
    public void missingRequirementsAreReported() throws Exception {
        Path program = folder.newFile("program.py").toPath();
        Files.writeString(program, "import sear\ntry:\n    import sear.gym\nexcept ImportError as error:\n    "
            + "print(error)\n");
        Path blocked = folder.newFolder("blocked").toPath();
        Files.writeString(blocked.resolve("gymnasium.py"), "raise ImportError('not here')\n");
        assertEquals("sear.gym needs Gymnasium: pip install gymnasium\n",
            run(0, blocked + File.pathSeparator + PACKAGES, program));
        Files.writeString(blocked.resolve("torch.py"), "raise ImportError('not here', name='torch')\n");
        for (String module : List.of("matplotlib", "gymnasium")) {
            Files.writeString(blocked.resolve(module + ".py"), "");
        }
        String text = run(1, blocked + File.pathSeparator + PACKAGES,
            ROOT.resolve("examples/python3/learn_wall_follower.py"));
        assertTrue(text, text.matches("(?s).* is missing\\. Install the requirements: pip install \\./python\\[gym\\] "
            + "stable-baselines3 matplotlib\n"));
        assertFalse(text, text.contains("Traceback"));
    }

    private static List<String> blocks() {
        return DocBlock.of("docs/learning.md", "python3");
    }

    /** Returns the output of the page's n-th block. */
    private String block(int number) throws Exception {
        Path program = folder.getRoot().toPath().resolve("block" + number + ".py");
        Files.writeString(program, blocks().get(number));
        return run(0, gymnasium(), program);
    }

    private static double number(String text, String pattern) {
        Matcher matcher = Pattern.compile(pattern).matcher(text);
        assertTrue(text, matcher.find());
        return Double.parseDouble(matcher.group(1));
    }

    @Test
    public void thePagesProgramsRun() throws Exception {
        assertEquals("each has its line here", 6, blocks().size());
        assertTrue("by chance it crashes", number(block(0), "return (-?[0-9.]+)") < 0);
        assertTrue("it drives in a circle", number(block(1), "driven ([0-9.]+) m") > 1);
        assertTrue("it steers", number(block(2), "turned left by (-?[0-9]+) degrees") > 90);
        assertEquals("it keeps away from the wall", 0.5, number(block(3), "on average ([0-9.]+) m"), 0.3);
        assertEquals("360 rows of 480 pixels\n", block(4));
        assertEquals("four worlds", 4, number(block(5), "(\\d+) worlds"), 0);
    }
}
