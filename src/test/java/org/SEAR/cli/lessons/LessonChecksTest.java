// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.SEAR.lessons.LessonRun;
import org.SEAR.project.Project;
import org.junit.After;
import org.junit.Before;
import org.junit.BeforeClass;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.Runtime;
import org.python.core.PySystemState;
import org.python.util.PythonInterpreter;

/**
 * Check of each lesson: it accepts the reference solution and names what the starting script and typical wrong
 * solutions lack. A wrong solution is the right one with some words changed. The scripts run in this process; the
 * checks read their records.
 */
@Category(Slow.class)
public class LessonChecksTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String[] PROPERTIES = {"sear.home", "sear.project", "sear.headless", "sear.speed",
        "sear.record", "sear.threads"};

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private final List<String> before = new ArrayList<>();

    @BeforeClass
    public static void python() {
        java.util.Properties settings = new java.util.Properties();
        settings.setProperty("python.import.site", "false");
        settings.setProperty("python.cachedir.skip", "true");
        PythonInterpreter.initialize(System.getProperties(), settings, new String[0]);
    }

    @Before
    public void settings() {
        for (String name : PROPERTIES) {
            before.add(System.getProperty(name));
        }
        System.setProperty("sear.home", ROOT.toString());
        System.setProperty("sear.headless", "true");
        System.setProperty("sear.speed", "max");
        System.setProperty("sear.threads", "1");
    }

    @After
    public void back() {
        for (int i = 0; i < PROPERTIES.length; i++) {
            if (before.get(i) == null) {
                System.clearProperty(PROPERTIES[i]);
            } else {
                System.setProperty(PROPERTIES[i], before.get(i));
            }
        }
    }

    private static String solution(String name) throws IOException {
        return Files.readString(ROOT.resolve("solutions").resolve(name + ".py"));
    }

    /** Runs a script and returns its check's result. */
    private LessonRun run(String name, String script) throws Exception {
        Lesson lesson = Lesson.find(name);
        Path place = folder.newFolder().toPath();
        Project world = lesson.unpack(place.resolve("world"));
        lesson.unpack(place);
        System.setProperty("sear.project", place.resolve("SEARproject").toString());
        System.setProperty("sear.record", place.resolve("run.searlog").toString());
        StringWriter printed = new StringWriter();
        PySystemState state = new PySystemState();
        state.setCurrentWorkingDir(place.toString());
        try (PythonInterpreter python = new PythonInterpreter(null, state)) {
            python.setOut(printed);
            python.exec("from org.myrobotlab.service import Runtime");
            // a wrong script may never arrive
            python.exec(script.replace("while True:", "while sear.getTime() < 100:"));
        } finally {
            Runtime.releaseService("sear");
        }
        LessonCheck check = new LessonCheck(lesson);
        LessonRun run = new LessonRun(world, place, script, printed.toString());
        run.follow(place.resolve("run.searlog"), world, check.getSeconds());
        check.look(run);
        return run;
    }

    private void passes(String name) throws Exception {
        LessonRun run = run(name, solution(name));
        assertEquals(name, List.of(), run.getMissing());
        assertEquals(name, List.of(), run.getByHand());
        assertTrue(name, run.getAsked() > 1);
    }

    /** @param changes old text of the solution, its replacement, and the expected message of the check */
    private void fails(String name, String[]... changes) throws Exception {
        assertTrue(name, !run(name, Files.readString(ROOT.resolve("lessons").resolve(name).resolve(name + ".py")))
            .getMissing().isEmpty());
        for (String[] change : changes) {
            String script = solution(name);
            assertTrue(name + " has no " + change[0], script.contains(change[0]));
            LessonRun run = run(name, script.replace(change[0], change[1]));
            assertTrue(name + " with " + change[1] + ": " + run.getMissing(), String.join("\n", run.getMissing())
                .contains(change[2]));
        }
    }

    private static String[] with(String right, String wrong, String said) {
        return new String[] {right, wrong, said};
    }

    @Test
    public void eachLessonHasAllThatItNeeds() throws IOException {
        assertEquals(8, Lesson.all().size());
        for (Lesson lesson : Lesson.all()) {
            assertTrue(lesson.getName(), Files.exists(ROOT.resolve("solutions").resolve(lesson.getName() + ".py")));
            assertTrue(lesson.getName(), !lesson.title().isEmpty()
                && Files.exists(lesson.check().resolveSibling("world.png")));
        }
        try (Stream<Path> solutions = Files.list(ROOT.resolve("solutions"))) {
            assertEquals(8, solutions.filter(one -> one.toString().endsWith(".py"))
                .collect(Collectors.toList()).size());
        }
    }

    @Test
    public void square() throws Exception {
        String told = String.join("\n", run("square", Files.readString(ROOT.resolve("lessons/square/square.py")))
            .getMissing());
        assertTrue(told, DocBlock.of("docs/lessons.md", "text").get(0).endsWith(told.replace("You ", "- You ") + "\n"));
        passes("square");
        fails("square", with("sear.spin(45)", "sear.spin(30)", "m of the second corner; 0.1 m is asked"),
            with("spin(45)", "spin(-45)", "You came within 1.00 m of the second corner"),
            with("sear.simSleep(5)", "sear.simSleep(4)", "m of the first corner"),
            with("range(4)", "range(3)", "of the start again"),
            with("print(\"Once", "sear.spin(20)\nsear.simSleep(1)\nsear.driveStraight(0.1)\n"
                + "sear.simSleep(0.5)\nprint(\"Once", "your robot was still moving"));
        for (String still : new String[] {"", "sear.driveStraight(0.2)\n", "sear.simSleep(2)\n"}) {
            String said = String.join("\n",
                run("square", "sear = Runtime.start('sear', 'SEAR')\nsear.startSimulation()\n" + still).getMissing());
            assertTrue(said, said.contains("Your robot drove 0.00 m: ") && !said.contains("still moving"));
        }
    }

    @Test
    public void doingNothingGivesNoPoints() throws Exception {
        for (Lesson lesson : Lesson.all()) {
            String name = lesson.getName();
            for (String nothing : new String[] {"", "sear.simSleep(" + new LessonCheck(lesson).getSeconds() + ")\n"}) {
                LessonRun run = run(name, "sear = Runtime.start('sear', 'SEAR')\nsear.startSimulation()\n" + nothing);
                assertEquals(name + ", " + nothing + ": " + run.getMissing(), 0, run.getMet());
                assertTrue(name, run.getAsked() > 0);
            }
            LessonRun right = run(name, solution(name));
            assertEquals(name, right.getAsked(), right.getMet());
        }
        LessonRun answer = run("odometry", "sear = Runtime.start('sear', 'SEAR')\nsear.startSimulation()\n"
            + "print('I am at x 0, z 0, heading 90')\n");
        assertEquals(answer.getMissing().toString(), 0, answer.getMet());
        LessonRun blank = run("map", "sear = Runtime.start('sear', 'SEAR')\nsear.startSimulation()\n"
            + "open('map.txt', 'w').write('\\n'.join(['.' * 42] * 42))\n");
        assertEquals(blank.getMissing().toString(), 0, blank.getMet());
    }

    @Test
    public void avoid() throws Exception {
        passes("avoid");
        fails("avoid", with("< 0.3", "< 0.1", "You bumped into something"), with("getTime() < 60", "getTime() < 30",
            "it is to drive for 60 s"), with("sear.driveStraight(0.2)", "sear.driveStraight(0.02)", "6 m are asked"));
    }

    @Test
    public void wall() throws Exception {
        passes("wall");
        fails("wall", with("WANTED = 0.3", "WANTED = 0.6", "m off the distance that is asked"),
            with("< 100", "< 20", "once round is asked"),
            with("steer(0, 0.8)", "steer(SPEED, 0)", "You bumped into something"));
    }

    @Test
    public void line() throws Exception {
        passes("line");
        fails("line", with("0.15 - 7 * off, 0.15 + 7 * off", "0.15 + 7 * off, 0.15 - 7 * off",
            "m off the line, the first time after"),
            with("< 40", "< 15", "of 12 parts of the way round"), with("7 * off", "0.5 * off", "m off the line"));
    }

    @Test
    public void map() throws Exception {
        passes("map");
        fails("map", with("for x, z in STOPS:", "for x, z in STOPS[:1]:", "are in your map; 90 % are asked"),
            with("mark(x + (scan[i] + 0.02) * north, z + (scan[i] + 0.02) * east, 4)",
                "mark(x - scan[i] * north, z - scan[i] * east, 4)",
                "where nothing is"), with("\"map.txt\"", "\"other.txt\"", "There is no file map.txt"));
    }

    @Test
    public void gps() throws Exception {
        passes("gps");
        fails("gps", with("atan2(east, north)", "atan2(north, east)", "of the first waypoint"),
            with("sear.driveStraight(0)\n", "sear.driveStraight(0.2)\n", "At the end your robot was still moving"),
            with(" < 0.1:", " < 1:", "m of the first waypoint; 0.4 m is asked"));
    }

    @Test
    public void odometry() throws Exception {
        passes("odometry");
        fails("odometry", with("0.048, 0.05", "0.05, 0.05", "0.1 m is allowed"),
            with("TRACK = 0.2", "TRACK = 0.3", "5 degrees are allowed"),
            with("before = now\n", "\n", "0.1 m is allowed"),
            with("print(", "print(sear.getPose(\"robot\"))\nprint(", "Your script asks sear.getPose"));
    }

    @Test
    public void pid() throws Exception {
        passes("pid");
        fails("pid", with("KI, KD = 2.0, 1.5, 1.0", "KI, KD = 2.0, 0, 1.0", "0.50 m is asked, give or take 0.01 m"),
            with("KI, KD = 2.0, 1.5, 1.0", "KI, KD = 2.0, 1.5, 0", "It came as near as"),
            with("KP, KI, KD = 2.0, 1.5, 1.0", "KP, KI, KD = 0.5, 0.1, 0", "it stayed within 0.05 m"),
            with("WANTED = 0.5", "WANTED = 0.6", "0.50 m is asked, give or take 0.01 m"),
            with("< 20", "< 10", "20 s are asked"));
    }

    @Test
    public void aTeachersOwnLessonIsAFolderOfTheSameForm() throws Exception {
        Path own = folder.newFolder("parking").toPath();
        Files.copy(ROOT.resolve("lessons/square/world.sear"), own.resolve("world.sear"));
        Files.copy(ROOT.resolve("lessons/square/square.py"), own.resolve("parking.py"));
        Files.writeString(own.resolve("check.py"), DocBlock.of("docs/lessons.md", "python").get(0));
        String script = Files.readString(own.resolve("parking.py"));
        LessonRun run = run(own.toString(), script);
        assertEquals(List.of(), run.getMissing());
        assertEquals(0, run.getMeasures().get("metres off"), 0.05);
        List<String> missing = run(own.toString(), script.replace("simSleep(5)", "simSleep(3)")).getMissing();
        assertEquals(1, missing.size());
        assertTrue(missing.toString(), missing.get(0)
            .matches("You stand 0\\.[34]\\d m from the parking lot; 0\\.2 m is asked\\."));
        Files.writeString(own.resolve("check.py"), "SECONDS = 0\ndef check(run): pass\n");
        IOException legal = assertThrows(IOException.class, () -> new LessonCheck(Lesson.find(own.toString())));
        assertTrue(legal.getMessage(), legal.getMessage().endsWith("SECONDS is 0.0, legal: above 0 to 3600.0"));
        Files.delete(own.resolve("world.sear"));
        assertTrue(assertThrows(IOException.class, () -> Lesson.find(own.toString())).getMessage()
            .endsWith("it lacks world.sear"));
    }

    @Test
    public void movingTheRobotByHandIsDetected() throws Exception {
        LessonRun run = run("square", solution("square") + "sear.setVelocity(\"robot\", 0, 0, "
            + "1)\nsear.simSleep(0.1)\n");
        assertEquals(1, run.getByHand().size());
        assertTrue(run.getByHand().toString(), run.getByHand().get(0)
            .startsWith("robot was pushed or given a velocity at 32."));
    }

    @Test
    public void aScriptsOwnRecordDoesNotDisturbTheCheck() throws Exception {
        String script = solution("square").replace("sear.startSimulation()", "sear.recordRun(\"" + folder.getRoot()
            + "/own.searlog\")\nsear.startSimulation()");
        assertEquals(List.of(), run("square", script).getMissing());
        assertTrue(Files.size(folder.getRoot().toPath().resolve("own.searlog")) > 1000);
    }

    @Test
    public void theLastTryCounts() throws Exception {
        String drive = solution("square").substring(solution("square").indexOf("for side"));
        LessonRun run = run("square", solution("square")
            .replace("sear.startSimulation()\n", "sear.startSimulation()\nsear.driveStraight(-0.3)\n"
            + "sear.simSleep(3)\nsear.reset()\n"));
        assertTrue(drive, drive.contains("spin") && run.getMissing().isEmpty());
    }
}
