// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.StringWriter;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import javax.xml.parsers.DocumentBuilderFactory;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.w3c.dom.Element;
import picocli.CommandLine;

/** {@code sear lessons}, {@code sear lesson} and {@code sear grade}, by the commands of docs/lessons.md. */
@Category(Slow.class)
public class GradeTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String START = "sear = Runtime.start(\"sear\", \"SEAR\")\nsear.startSimulation()\n";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    /** Returns the output of a command run in this process. */
    private String here(Object command, String... arguments) {
        String before = System.getProperty("sear.home");
        System.setProperty("sear.home", ROOT.toString());
        try {
            StringWriter out = new StringWriter();
            CommandLine line = new CommandLine(command).setOut(new PrintWriter(out)).setErr(new PrintWriter(out));
            return line.execute(arguments) + "\n" + out;
        } finally {
            if (before == null) {
                System.clearProperty("sear.home");
            } else {
                System.setProperty("sear.home", before);
            }
        }
    }

    @Test
    public void lessonsAreListedAndHandedOutOnce() throws Exception {
        assertEquals(List.of("sear lessons"), DocBlock.commands("docs/lessons.md", "sear lessons"));
        String list = here(new LessonsCommand());
        assertTrue(list, list.startsWith("0\n") && list.contains("square     Drive a square") && list.contains("pid "));
        String[] words = DocBlock.commands("docs/lessons.md", "sear lesson square").get(0).split(" ");
        String to = folder.getRoot().toPath().resolve(words[3]).toString();
        String told = here(new LessonCommand(), words[2], to);
        assertTrue(told, told.startsWith("0\nDrive a square is in ") && told.contains("sear grade square.py"));
        try (java.util.stream.Stream<Path> files = Files.list(Path.of(to))) {
            assertEquals("[README.md, SEARproject, square.py, world.png]",
                Arrays.toString(files.map(one -> one.getFileName().toString())
                .filter(name -> !name.startsWith(".")).sorted().toArray()));
        }
        assertTrue(here(new LessonCommand(), "square", to).startsWith("2\nsear lesson: "));
        String unknown = here(new LessonCommand(), "squar", to);
        assertTrue(unknown, unknown.contains("there is no lesson \"squar\", legal: avoid, gps, line, map, odometry, "
            + "pid, square, wall"));
    }

    @Test
    public void aScriptOfAnotherNameAndOneWithItsOwnWorldAreExplained() throws Exception {
        Path mine = folder.newFile("my_try.py").toPath();
        String unnamed = here(new GradeCommand(), mine.toString());
        assertTrue(unnamed, unnamed.startsWith("2\n")
            && unnamed.contains("my_try.py is not named after a lesson, legal: avoid, ")
            && unnamed.contains("sear grade --lesson NAME "));
        String script = "sear = Runtime.start('sear', 'SEAR')\n# newProject()\nsear.newProject()\nFloor('f', 5, 5)\n";
        assertEquals("Line 3 of square.py replaces or changes the lesson's world (newProject): the world is there"
            + " already. Delete all lines that make objects, and only start and drive.",
            ErrorWords.otherWorld("square.py", script, "another project"));
        assertTrue(ErrorWords.otherWorld("square.py", "sear.startSimulation()", "why").contains("unchanged. (why)"));
    }

    private void handIn(String pupil, String script) throws Exception {
        Files.writeString(folder.getRoot().toPath().resolve("handed-in").resolve(pupil + ".py"), script);
    }

    @Test
    public void aScriptCostsItsOwnMarkOnly() throws Exception {
        folder.newFolder("handed-in", "nobody");
        handIn("right", Files.readString(ROOT.resolve("solutions/square.py")));
        handIn("endless", START + "import time\nwhile True:\n    time.sleep(1)\n");
        handIn("forever", START + "sear.driveStraight(0.2)\nwhile True:\n    try:\n        sear.simSleep(1)\n    "
            + "except:\n        pass\n");
        handIn("greedy", "many = []\nwhile True:\n    many.append('x' * 20000000)\n");
        handIn("window", START + "sear.simSleep(1)\nfrom javax.swing import "
            + "JFrame\nJFrame('hello').setVisible(True)\n");
        handIn("empty", "");
        handIn("builder", "from org.SEAR.POJOs import Box\nBox('help', 1, 1, 1, 0).move(3, 0, 3)\n" + START
            + "sear.simSleep(1)\nrun = check = lambda *all: True\nprint('Passed: all 7 of 7')\n");
        String command = DocBlock.commands("docs/lessons.md", "sear grade handed-in").get(0);
        List<String> words = SearProcess.command("-Xmx256m", "-Dsear.home=" + ROOT);
        words.addAll(Arrays.asList(command.split(" ")).subList(1, command.split(" ").length));
        File said = folder.newFile();
        Process process = new ProcessBuilder(words).directory(folder.getRoot()).redirectErrorStream(true)
            .redirectOutput(said).start();
        try {
            assertTrue("sear grade hangs", process.waitFor(400, TimeUnit.SECONDS));
        } finally {
            process.destroyForcibly();
        }
        String text = Files.readString(said.toPath());
        assertEquals(text, 1, process.exitValue());
        Map<String, String> lines = new TreeMap<>();
        for (String line : Files.readAllLines(folder.getRoot().toPath().resolve("marks/marks.csv"))) {
            lines.put(line.split(",")[0], line);
        }
        assertEquals(text, 9, lines.size());
        assertTrue(text, lines.get("right").startsWith("right,square,passed,7,7,"));
        assertTrue(text, lines.get("endless").startsWith("endless,square,endless,")
            && lines.get("endless").contains("Is there a loop without"));
        assertTrue(text, lines.get("forever").startsWith("forever,square,not yet,") && lines.get("forever")
            .contains("of the second corner"));
        assertTrue(text, lines.get("greedy").startsWith("greedy,square,too much memory,0,0,"));
        assertTrue(text, lines.get("window").startsWith("window,square,error,") && lines.get("window")
            .contains("at line 5: "));
        assertTrue(text, lines.get("empty").startsWith("empty,square,nothing to mark,0,0,"));
        assertTrue(text, lines.get("nobody").startsWith("nobody,square,nothing to mark,0,0,"));
        assertTrue(text, lines.get("builder").startsWith("builder,square,not yet,0,0,")
            && lines.get("builder").contains("replaces or changes the lesson's world"));
        assertTrue(text, text.contains("1 of 8 have passed"));
        Element suite = DocumentBuilderFactory.newInstance().newDocumentBuilder()
            .parse(new File(folder.getRoot(), "marks/marks.xml")).getDocumentElement();
        assertEquals("8 4 3", suite.getAttribute("tests") + " " + suite.getAttribute("failures") + " "
            + suite.getAttribute("errors"));
    }
}
