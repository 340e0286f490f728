// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.contests;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.SEAR.lessons.LessonRun;
import org.SEAR.project.Project;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.PercentProgress;
import org.junit.BeforeClass;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.Runtime;
import org.python.util.PythonInterpreter;
import picocli.CommandLine;

/** {@code sear contest} with the commands of docs/contests.md and with failing entries. */
@Category(Slow.class)
public class ContestTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String START = "sear = Runtime.start(\"sear\", \"SEAR\")\nsear.startSimulation()\n";
    private static final String REFEREE = "SECONDS = 4\ndef stepped(contest):\n    for entry in "
        + "contest.entries:\n        entry.points = entry.z\n";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @BeforeClass
    public static void python() {
        java.util.Properties settings = new java.util.Properties();
        settings.setProperty("python.import.site", "false");
        settings.setProperty("python.cachedir.skip", "true");
        PythonInterpreter.initialize(System.getProperties(), settings, new String[0]);
    }

    private static String run(List<String> arguments) {
        StringWriter out = new StringWriter();
        CommandLine line = new CommandLine(new ContestCommand()).setOut(new PrintWriter(out))
            .setErr(new PrintWriter(out));
        return line.execute(arguments.toArray(new String[0])) + "\n" + out;
    }

    /** Runs the race of the page, with results in this folder. */
    private String race(String out) {
        List<String> words = new ArrayList<>();
        for (String word : DocBlock.commands("docs/contests.md", "sear contest").get(0).split(" ")) {
            words.add(word.startsWith("contests/") ? ROOT.resolve(word).toString() : word);
        }
        words.addAll(List.of("--out", folder.getRoot() + "/" + out));
        return run(words.subList(2, words.size()));
    }

    @Test
    public void theRaceOfThePageIsTheSameEachTime() throws Exception {
        assertEquals(DocBlock.of("docs/contests.md", "python").get(0),
            Files.readString(ROOT.resolve("contests/race/referee.py")));
        String told = race("first");
        assertEquals("0\n" + DocBlock.of("docs/contests.md", "text").get(0),
            told.substring(0, told.indexOf("\nWritten")));
        race("second");
        Path first = folder.getRoot().toPath().resolve("first");
        Path second = folder.getRoot().toPath().resolve("second");
        assertEquals(Files.readString(first.resolve("scores.csv")), Files.readString(second.resolve("scores.csv")));
        assertArrayEquals(Files.readAllBytes(first.resolve("contest.searlog")),
            Files.readAllBytes(second.resolve("contest.searlog")));
        assertTrue(Files.exists(first.resolve("hasty.txt")));
        Project world = Bundle.load(ROOT.resolve("contests/race/world.sear"), folder.getRoot().toPath()
            .resolve("SEARproject"), new PercentProgress("opening", first, line -> { }));
        LessonRun again = new LessonRun(world, first, "", "");
        again.follow(first.resolve("contest.searlog"), world, 90);
        assertEquals(0, Math.max(0, 5.5 - Arrays.stream(again.trail("red").getZ()).max().orElse(0)), 0);
        assertEquals(0, Math.max(0, 5.5 - Arrays.stream(again.trail("blue").getZ()).max().orElse(0)), 0);
    }

    /** Makes a contest of seven rovers side by side. */
    private Path rovers(String referee) throws Exception {
        Path contest = folder.newFolder().toPath();
        Files.writeString(contest.resolve("referee.py"), referee);
        String before = System.getProperty("sear.project");
        System.setProperty("sear.project", contest.resolve("SEARproject").toString());
        try (PythonInterpreter python = new PythonInterpreter()) {
            python.exec("from org.myrobotlab.service import Runtime\nfrom org.SEAR.POJOs import Distance, "
                + "Floor, Robots\n"
                + "sear = Runtime.start('sear', 'SEAR')\nsear.newProject()\nFloor('floor', 40, 40)\nfor i "
                + "in range(7):\n    robot = Robots.rover('rover%d' % i)\n    robot.move(2 * i, 0, 0)\n    "
                + "robot.addComponent(Distance('ping%d' % i, 'laser'))\n"
                + "sear.saveProject('" + contest.resolve("world.sear") + "')\n");
        } finally {
            Runtime.releaseService("sear");
            if (before == null) {
                System.clearProperty("sear.project");
            } else {
                System.setProperty("sear.project", before);
            }
        }
        return contest;
    }

    private static List<String> entered(Path contest, String... namesAndScripts) throws Exception {
        List<String> arguments = new ArrayList<>(List.of(contest.toString()));
        for (int i = 0; i < namesAndScripts.length; i += 2) {
            Path script = contest.resolve(namesAndScripts[i] + ".py");
            Files.writeString(script, namesAndScripts[i + 1]);
            arguments.add(script.toString());
        }
        arguments.addAll(List.of("--limit", "8", "--out", contest.resolve("result").toString()));
        return arguments;
    }

    /** A script that ends the process must not end the contest with status 0. */
    @Test
    public void aScriptThatEndsTheProgramIsNamed() throws Exception {
        List<String> arguments = entered(rovers(REFEREE), "good", START + "while True:\n    sear.simSleep(0.5)\n",
            "leaves", START + "sear.simSleep(1)\nimport os\nos._exit(0)\n");
        Path temporary = folder.newFolder().toPath();
        List<String> command = SearProcess.command("-Djava.io.tmpdir=" + temporary);
        command.add("contest");
        command.addAll(arguments);
        Path said = folder.newFile().toPath();
        Process process = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(said.toFile()).start();
        int status = process.waitFor();
        String text = Files.readString(said);
        assertTrue(text, text.contains("sear contest: the script of leaves ended the whole program at 1.0 s"));
        assertEquals(text, 1, status);
        try (Stream<Path> left = Files.list(temporary)) {
            assertEquals("[]", left.filter(one -> one.getFileName().toString().startsWith("sear"))
                .collect(Collectors.toList()).toString());
        }
    }

    private static Map<String, String> scores(Path contest) throws Exception {
        Map<String, String> lines = new TreeMap<>();
        for (String line : Files.readAllLines(contest.resolve("result/scores.csv"))) {
            lines.put(line.split(",")[1], line.split(",", 3)[2]);
        }
        return lines;
    }

    @Test
    public void aFailingScriptAffectsOnlyItsOwnRobot() throws Exception {
        Path contest = rovers(REFEREE);
        String good = START + "sear.driveStraight(0.3)\nprint sear.getSensorNames()\nwhile True:\n    "
            + "sear.simSleep(0.5)\n";
        assertTrue(run(entered(contest, "good", good)).startsWith("0\n"));
        String alone = scores(contest).get("good");
        String told = run(entered(contest, "good", good,
            "failing", START + "sear.driveStraight(0.3)\nsear.simSleep(1)\nprint 1 / 0\n",
            "hanging", START + "sear.driveStraight(0.3)\nsear.simSleep(1)\ntry:\n    while True: pass\nexcept:\n    "
            + "sear.simSleep(1)\n", "short", START + "sear.driveStraight(0.3)\nsear.simSleep(1)\n",
            "stubborn", START + "while True:\n    try:\n        sear.simSleep(1)\n    except:\n        pass\n",
            "modern", "#!/usr/bin/env python3\nprint('hello')\n",
            "spy", START + "sear.simSleep(1)\nsear.getReading(\"ping0\")\n"));
        assertTrue(told, told.startsWith("0\n"));
        Map<String, String> scores = scores(contest);
        assertEquals(alone, scores.get("good"));
        assertTrue(alone, alone.startsWith("1.1") && alone.endsWith(",,0,\"the time was over\""));
        assertTrue(told, scores.get("failing")
            .contains(",\"its script failed at 1.0 s, line 5: ZeroDivisionError: integer division"));
        assertTrue(told, scores.get("hanging")
            .contains(",\"its script hung at 1.0 s: it ran for 8.00 s without a simSleep\""));
        assertTrue(told, scores.get("short").contains(",\"its script ended at 1.0 s\""));
        assertTrue(told, scores.get("stubborn").endsWith(",,0,\"the time was over\""));
        assertTrue(told, scores.get("modern").contains("it is Python 3, but contests use Python 2.7"));
        assertTrue(told, scores.get("spy").contains("line 4: "));
        assertTrue(told, scores.get("spy").contains("no sensor of your robot is called \"\"ping0\"\", legal: ping6"));
        for (String name : List.of("failing", "hanging", "short")) {
            double metres = Double.parseDouble(scores.get(name).split(",")[0]);
            assertTrue(name + " " + metres, metres > 0.25 && metres < 0.4);     // the robot then stands still
        }
        assertEquals("[ping0]", Files.readString(contest.resolve("result/good.txt")).trim());
        assertEquals(List.of(), Thread.getAllStackTraces().keySet().stream().map(Thread::getName)
            .filter(name -> name.startsWith("contest ")).collect(Collectors.toList()));
        assertTrue(Files.readString(contest.resolve("result/failing.txt")).contains("ZeroDivisionError"));
    }

    /** Messages use the script's words, without the name of a service. */
    @Test
    public void callsUnavailableInAContestAreReported() throws Exception {
        Path contest = rovers(REFEREE);
        run(entered(contest, "pose", START + "sear.getPose('rover0')\n", "two",
            START + "sear.driveStraight('rover1', 1)\n",
            "motor", START + "sear.setMotorPower(None, 1)\n", "fast", START + "sear.setWheelSpeeds(0, -101)\n"));
        Map<String, String> scores = scores(contest);
        assertTrue(scores.toString(), scores.get("pose")
            .endsWith("AttributeError: in a contest sear has no attribute 'getPose': a script knows only its robot's "
                + "sensors, such as getDistanceResult and getOdomResult, and its commands (docs/contests.md)\""));
        assertTrue(scores.toString(), scores.get("two")
            .contains("expected 1 args; got 2, legal: sear.driveStraight(speed)"));
        assertTrue(scores.toString(), scores.get("motor")
            .contains("no motor of your robot is called \"\"null\"\", legal: leftMotor, rightMotor"));
        assertTrue(scores.toString(), scores.get("fast")
            .contains("setWheelSpeeds: right is -101.0, legal: -100.0 to 100.0 m/s"));
        List<String> twice = entered(contest, "one", START);
        twice.add("one=" + twice.get(1));
        assertTrue(run(twice), run(twice).contains("two entries are called \"one\"; NAME="));
    }

    @Test
    public void theRefereeDecidesTheResult() throws Exception {
        Path contest = rovers("SECONDS = 100\ndef positions(contest):\n    contest.entries[0].robot = 'rover5'\n"
            + "    contest.entries[1].place(-3, 1, 0)\n"
            + "def started(contest):\n    print [entry.robot for entry in contest.entries]\n"
            + "def stepped(contest):\n    one, two, three = contest.entries\n    one.points = two.points = 1\n"
            + "    if contest.time > 0.5: three.disqualify('snoring')\n"
            + "    if two.x > -2.5: two.finish('there')\n    if contest.time > 3: contest.end('enough')\n"
            + "def finished(contest):\n    contest.entries[2].points = 9\n    print '%.1f s' % contest.time\n");
        String drive = START + "sear.driveStraight(0.3)\nsear.simSleep(60)\n";
        String told = run(entered(contest, "one", drive, "two", drive, "three", START + "sear.simSleep(60)\n"));
        assertTrue(told, told.startsWith("0\n[u'rover5', u'rover1', u'rover2']\n3.0 s\n"));
        List<String> lines = Files.readAllLines(contest.resolve("result/scores.csv"));
        assertTrue(told, lines.get(1).matches("1,two,1,[12]\\.\\d\\d,0,\"there\""));
        assertEquals(List.of("2,one,1,,0,\"enough\"", "3,three,9,,0,\"disqualified: snoring\""), lines.subList(2, 4));
        Files.writeString(contest.resolve("referee.py"), "SECONDS = 4\ndef stepped(contest):\n    contest.entrys\n");
        String wrong = run(entered(contest, "one", drive));
        assertTrue(wrong, wrong.startsWith("2\nsear contest: ")
            && wrong.contains("has an error, which is not an entrant's") && wrong.contains("line 3"));
        for (String[] odd : new String[][] {{"contest.entries[0].points = float('nan')",
            "points of one are NaN, legal: a number"},
            {"sys.exit(3)", "ended itself with status 3, legal: contest.end(words)"}}) {
            Files.writeString(contest.resolve("referee.py"), "import sys\nSECONDS = 4\ndef stepped(contest):\n    "
                + odd[0] + "\n");
            wrong = run(entered(contest, "one", drive));
            assertTrue(wrong, wrong.startsWith("2\nsear contest: ") && wrong.contains(odd[1]));
        }
        Files.writeString(contest.resolve("referee.py"),
            "SECONDS = 1\ndef stepped(contest): contest.entries[0].finish(None)\n");
        assertTrue(run(entered(contest, "one", drive)).startsWith("0\n"));
        Files.writeString(contest.resolve("referee.py"),
            "def positions(contest): contest.entries[0].place(float('nan'), 0, 0)\n"
            + "SECONDS = 1\ndef stepped(contest): pass\n");
        wrong = run(entered(contest, "one", drive));
        assertTrue(wrong, wrong.contains("place of one is x NaN, z 0.0, heading 0.0, legal: numbers"));
        Files.writeString(contest.resolve("referee.py"), "def stepped(contest): pass\n");
        assertTrue(run(entered(contest, "one", drive)).contains("lacks SECONDS, the simulated time of the contest"));
        assertTrue(run(List.of(folder.getRoot().toString(), "x.py")).contains("is not a contest: it lacks world.sear"));
        assertTrue(run(List.of(contest.toString(), "x.py"))
            .startsWith("2\nsear contest: x.py can't be read: there is no such file"));
    }

    @Test
    public void aRefereeThatHangsEndsTheContest() throws Exception {
        Path contest = rovers(REFEREE);
        List<String> arguments = entered(contest, "one", START + "sear.simSleep(60)\n");
        arguments.set(arguments.indexOf("8"), "2");
        for (String[] one : new String[][] {{"def stepped(contest):\n    while True: pass\n", "stepped(contest)"},
            {"def stepped(contest): pass\nwhile True: pass\n", "it"}}) {
            Files.writeString(contest.resolve("referee.py"), "SECONDS = 4\n" + one[0]);
            String told = run(arguments);
            assertEquals("2\nsear contest: " + contest.resolve("referee.py") + " hung: " + one[1]
                + " ran for 2.00 s, legal: at most --limit, by the computer's clock\n", told);
        }
    }

    @Test
    public void bumpsAreCountedAndPlacesStored() throws Exception {
        Path contest = rovers("SECONDS = 8\ndef positions(contest):\n    for entry, z, heading in zip(contest.entries, "
            + "(0, 2), (90, -90)):\n        entry.place(-3, z, heading)\ndef stepped(contest): pass\n"
            + "def finished(contest):\n    one, two = contest.entries\n    print one.bumps == len(one.trail.bumps), "
                + "two.trail.length > 0.5\n");
        String drive = START + "sear.driveStraight(0.3)\nsear.simSleep(60)\n";
        String told = run(entered(contest, "one", drive, "two", drive));
        assertTrue(told, told.startsWith("0\nTrue True\n"));
        for (String name : List.of("one", "two")) {
            assertTrue(told, scores(contest).get(name).matches("0,,[1-9]\\d*,\"the time was over\""));
        }
    }
}
