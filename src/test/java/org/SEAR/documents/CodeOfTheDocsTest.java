// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static java.util.Map.entry;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.SEAR.Slow;
import org.SEAR.benchmark.PerformancePageTest;
import org.SEAR.cli.ClassCommandTest;
import org.SEAR.cli.ReadmeTest;
import org.SEAR.cli.ScriptProcess;
import org.SEAR.cli.SearCommandTest;
import org.SEAR.cli.install.DistributionTest;
import org.SEAR.cli.contests.ContestTest;
import org.SEAR.cli.lessons.GradeTest;
import org.SEAR.cli.lessons.LessonChecksTest;
import org.SEAR.cli.sweep.SweepTest;
import org.SEAR.learning.GymnasiumTest;
import org.SEAR.project.HandWrittenProjectTest;
import org.SEAR.project.ObjectDocsTest;
import org.SEAR.web.build.FirstRobotTest;
import org.SEAR.web.PanelsPageTest;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.python3.JupyterTest;
import org.myrobotlab.service.python3.Python3PackageTest;
import org.myrobotlab.service.thirdparty.OpencvExamplesTest;
import org.myrobotlab.service.thirdparty.ThirdPartyCameraTest;
import org.myrobotlab.service.thirdparty.ThirdPartyDriversTest;
import org.myrobotlab.service.thirdparty.ThirdPartyGpsTest;
import org.myrobotlab.service.thirdparty.ThirdPartyScannersTest;

/**
 * Runs every block of README, CONTRIBUTING and docs. Python that needs only a floor runs here, everything else in a
 * class of its own with the required surroundings. Commands are checked line by line.
 */
@Category(Slow.class)
public class CodeOfTheDocsTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    /** Pages whose Python runs here. Each page gets a new project, and its blocks run in order. */
    private static final List<String> HERE = List.of("docs/arduino.md", "docs/building.md", "docs/cameras.md",
        "docs/joints.md", "docs/objects.md",
        "docs/physics.md", "docs/projects.md", "docs/records.md", "docs/sensors.md", "docs/sketches.md",
        "docs/terrain.md", "docs/vehicles.md", "docs/walls.md", "docs/window.md");
    /**
     * By page and language, and for commands also by their beginning: the class that takes the block from the page and
     * runs it.
     */
    private static final Map<String, Class<?>> RUN_BY = new TreeMap<>(Map.ofEntries(
        entry("README.md python", ReadmeTest.class),
        entry("README.md sh build/install/sear/bin/sear", ReadmeTest.class),
        entry("README.md text", ReadmeTest.class),
        entry("docs/add-a-sensor.md java", AddASensorTest.class),
        entry("docs/add-a-sensor.md python", AddASensorTest.class),
        entry("docs/add-a-sensor.md sh ", AddASensorTest.class),
        entry("docs/add-a-sensor.md text", AddASensorTest.class),
        entry("docs/cameras.md python3", ThirdPartyCameraTest.class),
        entry("docs/cameras.md sh python3 examples/python3/", OpencvExamplesTest.class),
        entry("docs/classroom.md sh sear --headless", ClassCommandTest.class),
        entry("docs/classroom.md sh sear class --pupils names.txt", ClassCommandTest.class),
        entry("docs/classroom.md text", ClassCommandTest.class),
        entry("docs/contests.md python", ContestTest.class),
        entry("docs/contests.md sh sear contest", ContestTest.class),
        entry("docs/contests.md text", ContestTest.class),
        entry("docs/embedded-and-real.md sh java -cp", DistributionTest.class),
        entry("docs/first-robot.md python", FirstRobotTest.class),
        entry("docs/first-robot.md sh sear", FirstRobotTest.class),
        entry("docs/first-robot.md text", FirstRobotTest.class),
        entry("docs/install.md sh bin/sear install", DistributionTest.class),
        entry("docs/learning.md python3", GymnasiumTest.class),
        entry("docs/lessons.md python", LessonChecksTest.class),
        entry("docs/lessons.md sh sear grade handed-in", GradeTest.class),
        entry("docs/lessons.md sh sear lesson square", GradeTest.class),
        entry("docs/lessons.md sh sear lessons", GradeTest.class),
        entry("docs/lessons.md text", LessonChecksTest.class),
        entry("docs/notebooks.md python3", JupyterTest.class),
        entry("docs/objects.md text", ObjectDocsTest.class),
        entry("docs/objects.md xml", ObjectDocsTest.class),
        entry("docs/other-programs.md python", ReadmeTest.class),
        entry("docs/other-programs.md python3", ThirdPartyDriversTest.class),
        entry("docs/other-programs.md sh gpsd -N -n -b", ThirdPartyDriversTest.class),
        entry("docs/other-programs.md sh gpsd -N -n -s", ThirdPartyGpsTest.class),
        entry("docs/other-programs.md sh gpspipe ", ThirdPartyDriversTest.class),
        entry("docs/other-programs.md sh sear modem-lines", ThirdPartyScannersTest.class),
        entry("docs/panels.md html", PanelsPageTest.class),
        entry("docs/panels.md js", PanelsPageTest.class),
        entry("docs/panels.md sh curl", PanelsPageTest.class),
        entry("docs/performance.md sh scripts/benchmark", PerformancePageTest.class),
        entry("docs/projects.md text", SearCommandTest.class),
        entry("docs/projects.md xml", HandWrittenProjectTest.class),
        entry("docs/python3-http.md python3", Python3Test.class),
        entry("docs/python3.md python3", Python3PackageTest.class),
        entry("docs/python3.md sh python3 -m venv", Python3PackageTest.class),
        entry("docs/python3.md sh venv/bin/pip install", Python3PackageTest.class),
        entry("docs/python3.md sh sear examples/drive/maze_solver.py", Python3PackageTest.class),
        entry("docs/python3.md python", Python3PackageTest.class),
        entry("docs/scripting.md python", ScriptExamplesTest.class),
        entry("docs/sweeps.md python", SweepTest.class),
        entry("docs/sweeps.md python3", SweepTest.class),
        entry("docs/sweeps.md sh sear sweep ahead.py --seeds", SweepTest.class),
        entry("docs/sweeps.md sh sear sweep ahead.py --again", SweepTest.class),
        entry("docs/urdf.md python", UrdfPageTest.class)));
    private static final Map<String, String> NOT_RUN = new TreeMap<>(Map.of(
        "CONTRIBUTING.md sh MYROBOTLAB=", "it is CI, and runs this test",
        "docs/classroom.md sh podman ", "needs a registry of images; the page says what was tried",
        "docs/classroom.md sh ssh ", "needs a second computer",
        "docs/notebooks.md sh venv/bin/", "JupyterLab is some 100 packages; what it runs, a kernel, JupyterTest does",
        "docs/other-programs.md sh rosrun ", "needs ROS 1, which is in no package of Debian 12; the page says that it "
            + "was not tried"));
    private static final String GRADLE = "./gradlew ";
    private static final String BEFORE = "from org.SEAR.POJOs import Floor\nif sear.isSimulating(): "
        + "sear.stopSimulation()\nsear.newProject()\nfloor = Floor('ground', 9, 9)\n";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Test
    public void everyBlockIsRun() {
        TreeSet<String> unused = new TreeSet<>(RUN_BY.keySet());
        unused.addAll(NOT_RUN.keySet());
        TreeSet<String> orphans = new TreeSet<>();
        for (String page : DocBlock.pages()) {
            for (DocBlock block : DocBlock.of(page)) {
                if (block.language.equals("sh")) {
                    block.text.lines().map(line -> block + " " + line).filter(line -> !isRun(line, unused))
                        .forEach(orphans::add);
                } else if (!(HERE.contains(page) && block.language.equals("python"))
                    && !isRun(block.toString(), unused)) {
                    orphans.add(block + "\n" + block.text);
                }
            }
        }
        assertEquals("a block (or a line of commands) that no test runs: run it in a test that takes it by DocBlock, "
            + "and name that test here", "", String.join("\n", orphans));
        assertEquals("not in the pages any more", "[]", unused.toString());
    }

    private static boolean isRun(String what, TreeSet<String> unused) {
        boolean run = what.contains(".md sh " + GRADLE);
        for (Map<String, ?> known : List.of(RUN_BY, NOT_RUN)) {
            for (String key : known.keySet()) {
                if (key.contains(".md sh ") ? what.startsWith(key) : what.equals(key)) {
                    unused.remove(key);
                    run = true;
                }
            }
        }
        return run;
    }

    /** Ensures that the tests run the current text of the page. */
    @Test
    public void everyNamedClassReadsTheBlocksFromThePage() throws IOException {
        for (Map.Entry<String, Class<?>> one : RUN_BY.entrySet()) {
            String[] words = one.getKey().split(" ", 3);
            String source = source(one.getValue());
            boolean taken = source.contains("DocBlock.of(\"" + words[0] + "\")")
                || source.contains("DocBlock.of(\"" + words[0] + "\", \"" + words[1] + "\")")
                || words.length > 2 && source.contains("DocBlock.commands(\"" + words[0] + "\", \"" + words[2]);
            assertTrue(one.toString(), taken);
        }
        assertTrue(source(GradleCommandsTest.class).contains("GRADLE = \"" + GRADLE + "\";"));
        assertTrue(source(GradleCommandsTest.class)
            .contains("DocBlock.pages().stream().flatMap(page -> DocBlock.commands(page, GRADLE)"));
    }

    private static String source(Class<?> test) throws IOException {
        return Files.readString(ROOT.resolve("src/test/java").resolve(test.getName().replace('.', '/') + ".java"));
    }

    @Test
    public void thePythonOfThePagesRuns() throws Exception {
        StringBuilder script = new StringBuilder("sear = Runtime.start('sear', 'SEAR')\n");
        for (String page : HERE) {
            List<String> blocks = DocBlock.of(page, "python");
            assertTrue(page, !blocks.isEmpty());
            script.append(BEFORE).append(String.join("\n", blocks)).append("\nprint '").append(page)
                .append(" to the end'\n");
        }
        Path file = folder.getRoot().toPath().resolve("pages.py");
        Files.writeString(file, script);
        String output = ScriptProcess.run(folder.getRoot().toPath(), file);
        for (String page : HERE) {
            assertTrue(output, output.contains(page + " to the end"));
        }
    }
}
