// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.Rule;
import org.junit.rules.TemporaryFolder;
import org.junit.Test;
import org.SEAR.documents.DocBlock;
import org.SEAR.FreePort;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.SearProcess;

/** The command {@code sear} in its own JVM. */
public class SearCommandTest {
    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private String out;
    private String err;

    private int sear(String... arguments) throws IOException, InterruptedException {
        File outFile = folder.newFile();
        File errFile = folder.newFile();
        List<String> command = SearProcess.command("-Xmx256m", "-Dfile.encoding=UTF-8");
        command.addAll(Arrays.asList(arguments));
        Process process = new ProcessBuilder(command).directory(folder.getRoot()).redirectOutput(outFile)
            .redirectError(errFile).start();
        assertTrue("sear hangs", process.waitFor(240, TimeUnit.SECONDS));
        out = Files.readString(outFile.toPath());
        err = Files.readString(errFile.toPath());
        return process.exitValue();
    }

    /** Runs a command that prints through picocli and does not depend on the working folder in this process. */
    private int here(String... arguments) {
        StringWriter outText = new StringWriter();
        StringWriter errText = new StringWriter();
        int status = SearCommand.commandLine().setOut(new PrintWriter(outText)).setErr(new PrintWriter(errText))
            .execute(arguments);
        out = outText.toString();
        err = errText.toString();
        return status;
    }

    private String script(String code) throws IOException {
        Path file = folder.getRoot().toPath().resolve("script.py");
        Files.writeString(file, code);
        return "script.py";
    }

    @Test
    public void aScriptThatEndsIs0AndPrintsNothingElse() throws Exception {
        assertEquals(err, 0, sear(script("def input(data): pass\nprint 'h\u00e4llo', python.name, sys.argv"), "--port",
            "none", "--headless"));
        assertEquals("h\u00e4llo python ['script.py']\n", out);
        assertEquals("", err);
    }

    @Test
    public void aRobotInUrdfIsImported() throws Exception {
        Path file = folder.getRoot().toPath().resolve("arm.urdf");
        Files.copy(Paths.get(System.getProperty("sear.root", "."), "examples/arm.urdf"), file);
        assertEquals(err, 0, sear("import", "arm.urdf", "--fixed", "--joint", "lift=20"));
        assertTrue(out, out.contains("arm: arm, arm shoulder, arm upper, arm lower, arm left_finger, "
            + "arm right_finger\n"));
        assertTrue(out, out.contains("joint arm grip_right, 0.0 to 0.04, follows arm grip by 1.0\n"));
        assertTrue(Files.exists(folder.getRoot().toPath().resolve("SEARproject/robot/arm.xml")));
        Files.writeString(file, "<robot/>");
        assertEquals(2, sear("import", "arm.urdf"));
        assertEquals("sear import: arm.urdf: the number of links is 0, legal: 1 to 1000\n", err);
    }

    @Test
    public void aScriptThatRaisesIs1WithItsTraceback() throws Exception {
        assertEquals(1, sear(script("print 'first'\nraise ValueError('no')"), "--port", "none"));
        assertEquals("first\n", out);
        assertTrue(err, err.contains("File \"script.py\", line 2, in <module>")
            && err.trim().endsWith("ValueError: no"));
    }

    @Test
    public void sysExitGivesTheExitStatus() throws Exception {
        assertEquals(3, sear(script("sys.exit(3)"), "--port", "none"));
        assertEquals("", err);
    }

    @Test
    public void optionsReachTheSimulationAsSystemProperties() throws Exception {
        String code = "from java.lang import System\nprint [System.getProperty('sear.' + x) for x in ['headless', "
            + "'speed', 'seed', 'threads', 'parameter.gain']]";
        assertEquals(0, sear(script(code), "--headless", "--speed", "max", "--seed", "42", "--threads", "3", "--set",
            "gain=0.5", "--port", "none"));
        assertEquals("[u'true', u'max', u'42', u'3', u'0.5']\n", out);
    }

    @Test
    public void keepStaysUntilShutdown() throws Exception {
        String code = "Runtime.getInstance().addListener('started', python.name, 'go')\n"
            + "def go(name):\n  print 'callback'\n  Runtime.shutdown()\nRuntime.start('s', 'Serial')\n";
        assertEquals(err, 0, sear(script(code), "--keep", "--port", "none"));
        assertTrue(out, out.startsWith("callback\n"));
    }

    @Test
    public void theFirstLineHasTheAddressOfTheTabs() throws Exception {
        int port = FreePort.find();
        assertEquals(0, sear(script("print 'out'"), "--headless", "--port", String.valueOf(port)));
        assertEquals("out\n", out);
        assertEquals("Open this in a browser:\nhttp://localhost:" + port + "/\n", err);
    }

    @Test
    public void anotherPortReplacesAPortInUse() throws Exception {
        try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            int port = other.getLocalPort();
            assertEquals(err, 0, sear(script("print webgui.getPort(), webgui.isStarted()"), "--headless", "--port",
                String.valueOf(port)));
            String[] printed = out.trim().split(" ");
            assertEquals("Port " + port + " is in use by another program. Open this in a browser:\nhttp://localhost:"
                + printed[0] + "/\n", err);
            assertTrue(out, Integer.parseInt(printed[0]) > port && printed[1].equals("True"));
        }
    }

    @Test
    public void theTokenIsPrintedAndInAFileOfTheUser() throws Exception {
        String home = System.getProperty("user.home");
        int port = FreePort.find();
        Path file = Paths.get(home, ".sear", "token-" + port);
        assertEquals(err, 0, sear(script("print open('" + file + "').read()"), "--headless", "--token", "--port",
            String.valueOf(port)));
        assertTrue(out, out.trim().matches("[\\w-]{32}"));
        assertTrue(err, err.startsWith("Open this in a browser:\nhttp://localhost:" + port + "/?token=" + out.trim()
            + "\ntoken: " + file + " contains it"));
        assertFalse("it goes when the program ends", Files.exists(file));
    }

    @Test
    public void anUnusedParameterIsReported() throws Exception {
        assertEquals(err, 0, sear(script("sear = Runtime.start('sear', 'SEAR')\nprint sear.getParameter('speed', 0.3)"),
            "--set", "sped=2", "--port", "none"));
        assertTrue(out + err, out.contains("0.3") && err.contains("sear: the script did not read parameter sped: "));
    }

    @Test
    public void argumentsReachTheScript() throws Exception {
        assertEquals(err, 0, sear(script("print sys.argv"), "one", "--port", "none", "--", "--headless", "check"));
        assertEquals("['script.py', 'one', '--headless', 'check']\n", out);
    }

    @Test
    public void python3SyntaxIsReportedWithTheVersionOfThisPython() throws Exception {
        assertEquals(1, sear(script("x = 3\nprint f'{x} m'"), "--port", "none"));
        assertTrue(err, err.trim().endsWith("scripts are Python 2.7 (Jython), which has no f-strings: write \"%d "
            + "m\" % metres"));
        assertEquals(1, sear(script("print('a', end='')"), "--port", "none"));
        assertTrue(err, err.contains("scripts are Python 2.7 (Jython): write print"));
        assertEquals(1, sear(script("x = = 3"), "--port", "none"));
        assertFalse(err, err.contains("Python 2.7"));
    }

    @Test
    public void anUnknownNameIsReportedWithTheNearestKnownOne() throws Exception {
        String objects = "from org.SEAR.POJOs import *\n";
        assertMeant("LIDAR", objects + "Lidar('scanner')");
        assertMeant("robot", "robot = 1\nprint robt");
        assertMeant("setMass", objects + "Box('box', 1, 1, 1, 1).setmass(3)");
        assertMeant("startSimulation", "sear = Runtime.start('sear', 'SEAR')\nsear.startSimultion()");
        assertMeant("startSimulation", "sear = Runtime.start('sear', 'SEAR')\nsear.simulate()");
        assertMeant("isSimulating", "sear = Runtime.start('sear', 'SEAR')\nsear.isSimulatin()");
        assertMeant("stopSimulation", "sear = Runtime.start('sear', 'SEAR')\nsear.stopSimulating()");
        assertEquals(1, sear(script("qqqqqq"), "--port", "none"));
        assertFalse(err, err.contains("did you mean"));
    }

    private void assertMeant(String name, String lines) throws Exception {
        assertEquals(1, sear(script(lines), "--port", "none"));
        assertTrue(err, err.trim().endsWith("\ndid you mean " + name + "?"));
    }

    @Test
    public void anExceptionOfSeveralLinesBeginsWithItsCause() throws Exception {
        assertEquals(1, sear(script("raise ValueError('first\\nsecond')"), "--port", "none"));
        assertTrue(err, err.replaceFirst("^.*:\\s+", "").startsWith("first\nTraceback"));
    }

    @Test
    public void anErrorInACallbackMakesTheRunExitWith1() throws Exception {
        String code = "Runtime.getInstance().addListener('started', python.name, 'go')\ndone = []\n"
            + "def go(name):\n  done.append(1)\n  raise ValueError('in a callback')\nRuntime.start('s', "
            + "'Serial')\nRuntime.start('t', 'Serial')\nwhile len(done) < 2: sleep(0.01)";
        assertEquals(1, sear(script(code), "--port", "none"));
        assertTrue(err, err.contains("ValueError: in a callback"));
    }

    @Test
    public void aCallThatReportsAnErrorWithoutAnExceptionMakesTheRunExitWith1() throws Exception {
        String serial = "s = Runtime.start('s', 'Serial')\n";
        for (String call : List.of("Runtime.start('r', 'Roomba').connect('/dev/nowhere')", serial + "s.write(1)",
            serial + "s.addByteListener('pyton')", serial + "s.subscribe('nobody', 'publishRX')",
            "python.invokeOn('nobody', 'save')", "Runtime.startConfig('none')")) {
            assertEquals(call, 1, sear(script(call + "\nprint 'goes on'"), "--port", "none"));
            assertEquals(call, "goes on\n", out);
        }
        assertEquals(err, 0, sear(script(serial + "try: s.connect('/dev/nowhere')\nexcept: pass"), "--port", "none"));
    }

    @Test
    public void anErrorInACallbackIsReportedAlthoughTheScriptEnds() throws Exception {
        String code = "Runtime.getInstance().addListener('started', python.name, 'go')\nbegun = []\n"
            + "def go(name):\n  begun.append(1)\n  sleep(0.3)\n  raise NameError(\"name 'beguhn' is not "
            + "defined\")\nRuntime.start('s', 'Serial')\nwhile not begun: sleep(0.01)";
        assertEquals(1, sear(script(code), "--port", "none"));
        assertTrue(err, err.contains("did you mean begun?") && !err.contains("KeyboardInterrupt"));
    }

    @Test
    public void aRepeatedErrorIsPrintedOnceWithItsCount() throws Exception {
        String code = "Runtime.getInstance().addListener('started', python.name, 'go')\ndone = []\n"
            + "def go(name):\n  done.append(1)\n  raise ValueError('again')\nfor i in range(5): Runtime.start('s%d' % "
            + "i, 'Serial')\nwhile len(done) < 5: sleep(0.01)";
        assertEquals(1, sear(script(code), "--port", "none"));
        assertEquals(err, 3, err.split("ValueError: again", -1).length);
        assertTrue(err, err.contains("this error occurred 5 times:"));
    }

    @Test
    public void shellsGetTheirCompletion() throws Exception {
        assertEquals(0, here("generate-completion"));
        assertTrue(out, out.contains("complete -F _complete_sear") && out.contains("--headless"));
    }

    @Test
    public void checkWithoutAnArgumentChecksTheProjectHere() throws Exception {
        assertEquals(2, sear("check"));
        assertTrue(err, err.contains("SEARproject can't be read: there is no such file or folder"));
        Path environment = Files.createDirectories(folder.getRoot().toPath().resolve("SEARproject/environment"));
        Files.writeString(environment.resolve("a.xml"), "<Box><name>a</name><length>-1</length></Box>");
        assertEquals(2, sear("check"));
        assertTrue(out, out.contains("environment/a.xml"));
    }

    @Test
    public void invalidArgumentsAre2() throws Exception {
        assertEquals(2, sear("nix.py"));
        assertTrue(err, err.contains("nix.py can't be read"));
        for (String speed : new String[] {"fast", "0.0001"}) {
            assertEquals(2, here("--speed", speed));
            assertTrue(err, err.contains("--speed is \"" + speed + "\", legal: a number of 0.001 or more, or max"));
        }
        for (String threads : new String[] {"0", "257", "-1", "all", "1000000000000"}) {
            assertEquals(2, here("--threads=" + threads));
            assertTrue(err, err.contains("--threads is \"" + threads + "\", legal: 1 to 256"));
        }
        assertEquals(2, sear(script("pass"), "--port", "99999"));
        assertTrue(err, err.contains("--port is \"99999\", legal: 1 to 65535, or none"));
    }

    @Test
    public void checkPrintsEveryProblem() throws Exception {
        assertEquals(err, 0, sear(script("from org.SEAR.POJOs import Box\nBox('Box1', 1, 2, 3, 4)"), "--port", "none"));
        Path box = folder.getRoot().toPath().resolve("SEARproject/environment/Box1.xml");
        assertEquals(out + err, 0, sear("check", "."));
        Files.writeString(box, Files.readString(box).replaceAll("<mass>.*</mass>", "<mass>-1</mass>")
            .replaceAll("<width>.*</width>", "<width>x</width>"));
        assertEquals(2, sear("check", "SEARproject"));
        assertTrue(out, out.contains("environment/Box1.xml:") && out.contains("mass is \"-1\", legal: ")
            && out.contains("width is \"x\", legal: "));
        assertEquals(2, sear("check", "nix"));
    }

    /** {@code sear help check} shows help and does not check the project. */
    @Test
    public void helpShowsACommandWithoutRunningIt() throws Exception {
        assertEquals(0, here("help", "check"));
        assertTrue(out, out.startsWith("Usage: sear check"));
    }

    @Test
    public void aMisspeltCommandIsAnsweredWithTheNearestName() throws Exception {
        assertEquals(2, sear("chekc"));
        assertTrue(err, err.contains("sear: chekc can't be read: there is no such file. If it is a command, did you "
            + "mean check? Try"));
        assertEquals(2, sear("nix.py"));
        assertTrue(err, err.contains("sear: nix.py can't be read: there is no such file. Try sear --help."));
    }

    /** Finds examples like sear.loadProject. */
    @Test
    public void checkFindsTheExamplesInEveryFolder() throws Exception {
        assertEquals(out + err, 0, sear("check", "examples/office.sear"));
        assertTrue(out, out.contains("examples/office.sear: no problems"));
        assertEquals(2, sear("check", "examples/nowhere.sear"));
        assertTrue(err, err.contains("examples/nowhere.sear can't be read: there is no such file or folder"));
    }

    /** The crate of the docs with another mass, and the rover of the docs without its camera. */
    @Test
    public void checkPrintsTheExampleOfThePageAboutProjects() throws Exception {
        Path project = folder.getRoot().toPath().resolve("SEARproject");
        List<String> files = DocBlock.of("docs/projects.md", "xml");
        Files.writeString(Files.createDirectories(project.resolve("environment")).resolve("crate.xml"),
            DocBlock.of("docs/objects.md", "xml").get(0).replace("<mass>2<", "<mass>-1<"));
        Files.writeString(Files.createDirectories(project.resolve("robot")).resolve("rover.xml"), files.get(0));
        Files.writeString(project.resolve("robot/drive.xml"), files.get(1));
        assertEquals(2, sear("check", "SEARproject"));
        assertEquals(DocBlock.of("docs/projects.md", "text"), List.of(out));
    }

    @Test
    public void checkDistinguishesPartsOfOneNameByTheirRobots() throws Exception {
        assertEquals(err, 0, sear(script(
            "from org.SEAR.POJOs import Distance, Dynamics, Floor, SEARrobot\nFloor('floor', 20, 20)\n"
            + "for name, x in (('rover', 0), ('scout', 2)):\n    robot = SEARrobot(name)\n    drive = "
            + "Dynamics('drive', 3)\n"
            + "    robot.addComponent(drive)\n    drive.move(x, 0.1, 0)\n    robot.addComponent(Distance('ping'))\n"),
                "--port", "none"));
        assertEquals(out + err, 0, sear("check", "."));
        assertTrue(out + err, (out + err).contains("sensor rover/ping sees the ground")
            && (out + err).contains("sensor scout/ping sees the ground"));
        assertTrue(Files.isRegularFile(folder.getRoot().toPath().resolve("SEARproject/robot/rover/ping.xml")));
    }

    @Test
    public void checkFindsErrorsOfTheStart() throws Exception {
        Path project = Files.createDirectories(folder.getRoot().toPath().resolve("project"));
        Path robot = Files.createDirectories(project.resolve("robot")).resolve("r.xml");
        Files.writeString(robot, "<SEARrobot><name>r</name></SEARrobot>");
        assertEquals(2, sear("check", "project"));
        assertTrue(out, out.startsWith("robot/r.xml: robot r has no Dynamics, legal: "));
        Bundle.save(project, folder.getRoot().toPath().resolve("robot.sear"));
        assertEquals(2, sear("check", "robot.sear"));
        assertTrue(out, out.startsWith("robot/r.xml: robot r has no Dynamics, legal: "));
        Files.delete(robot);
        Path environment = Files.createDirectories(project.resolve("environment"));
        Files.writeString(environment.resolve("m.xml"), "<Model><name>m</name><path>m.glb</path></Model>");
        Files.writeString(Files.createDirectories(project.resolve("assets")).resolve("m.glb"),
            "glTF is binary, this is not");
        assertEquals(2, sear("check", "project"));
        assertTrue(out, out.startsWith("environment/m.xml: path is \"m.glb\", legal: a model that can be loaded"));
    }

    @Test
    public void checkWarnsOfARobotThatTipsOver() throws Exception {
        assertEquals(err, 0, sear(script("from org.SEAR.POJOs import Box, Floor, Robots\nFloor('floor', 9, 9)\nrover = "
            + "Robots.rover('rover')\n"
            + "mast = Box('mast', 0.1, 0.1, 0.1, 9)\nrover.addComponent(mast)\nmast.move(0, 0.5, 0.3)\n"),
                "--port", "none"));
        assertEquals(out + err, 0, sear("check"));
        assertTrue(out, out.contains("warning: robot rover falls over forwards at rest: its centre of mass "
            + "at x 0.000, y ") && out.endsWith("SEARproject: no problems\n"));
    }

    @Test
    public void aLargeProjectShowsItsProgress() throws Exception {
        String code = "from org.SEAR.POJOs import Box\nfrom java.nio.file import Files, Paths\nBox('Box1', "
            + "1, 2, 3, 4)\nf = open('SEARproject/assets/large.dat', 'wb') if "
            + "Files.createDirectories(Paths.get('SEARproject/assets')) else None\n"
            + "f.write('x' * (20 << 20))\nf.close()\n"
            + "s = Runtime.start('s', 'SEAR')\ns.saveProject('large.sear')\ns.loadProject('large.sear')\n";
        assertEquals(err, 0, sear(script(code), "--headless", "--port", "none"));
        assertTrue(err, err.contains("saving large.sear: 100 % of 20 MB (")
            && err.contains("loading large.sear: 100 % of 20 MB ("));
        assertEquals(out + err, 0, sear("check", "large.sear"));
        assertTrue(err, err.contains("checking large.sear: 100 % of 20 MB ("));
    }

    @Test
    public void checkDistinguishesGoodExamplesBrokenFoldersAndHostileBundles() throws Exception {
        Path examples = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath().resolve("examples");
        for (String example : new String[] {"avoider", "ball", "car", "dock", "line", "maze", "office", "ramps",
            "rover", "sensors", "truck", "turret"}) {
            Path bundle = examples.resolve(example + ".sear");
            assertEquals(out + err, 0, here("check", bundle.toString()));
            assertTrue(out, out.endsWith(bundle + ": no problems\n"));
            assertEquals("", err);
        }
        Path environment = Files.createDirectories(folder.getRoot().toPath().resolve("broken/environment"));
        Files.writeString(environment.resolve("a.xml"),
            "<Box>\n<name>a</name>\n<length>-1</length>\n<wheels>x</wheels>\n</Box>\n");
        Files.writeString(environment.resolve("b.xml"), "<java.lang.ProcessBuilder/>");
        assertEquals(2, sear("check", "broken"));
        assertTrue(out, out.contains("environment/a.xml:3: length is \"-1\", legal: ")
            && out.contains("environment/a.xml:4: <wheels> is unknown")
            && out.contains("environment/b.xml:1: <java.lang.ProcessBuilder> is not an object here"));
        assertTrue(err, err.startsWith("broken: problems: "));
    }

    @Test
    public void checkRefusesAHostileBundleAndWritesNothing() throws Exception {
        Path bundle = folder.getRoot().toPath().resolve("hostile.sear");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(bundle))) {
            for (String name : new String[] {"sear-version.txt", "../outside.xml", "environment/C:\\evil.xml"}) {
                zip.putNextEntry(new ZipEntry(name));
                zip.write("1\n".getBytes(StandardCharsets.US_ASCII));
                zip.closeEntry();
            }
        }
        assertEquals(2, sear("check", "hostile.sear"));
        assertTrue(out, out.contains("../outside.xml") && out.contains("evil.xml"));
        assertTrue(err, err.startsWith("hostile.sear: problems: "));
        assertTrue(Files.notExists(folder.getRoot().toPath().resolve("../outside.xml")));
        Files.writeString(bundle, "no zip file");
        assertEquals(2, sear("check", "hostile.sear"));
        assertTrue(out + err, (out + err).contains("hostile.sear"));
    }

    @Test
    public void aProjectIsPrintedAsItsScript() throws Exception {
        assertEquals(0, here("script", Paths.get(System.getProperty("sear.root", ".")).resolve("examples/maze.sear")
            .toString()));
        assertTrue(out, out.startsWith("from org.SEAR.POJOs import Box, ")
            && out.contains("addComponent(Distance(\"leftEye\", \"GP2Y0A21\", "));
        assertEquals(2, here("script", "nothing.sear"));
        assertTrue(err, err.contains("there is no such file or folder"));
    }

    @Test
    public void sensorsAreListedWithUnitsRangesAndDefaults() throws Exception {
        assertEquals(0, here("sensors"));
        for (String type : new String[] {"Accelerometer", "Bumper", "Camera", "ColorSensor", "Compass", "Distance",
            "GPS", "Gyroscope", "IMU", "LIDAR", "LineSensor",
            "Odometer"}) {
            assertTrue(out, out.contains(type + ": "));
        }
        assertTrue(out, out.contains("bandwidth: new readings a second. Legal: a number from 0.01 to 10000 "
            + "Hz; default 60"));
    }

    @Test
    public void helpAndVersionAre0() throws Exception {
        assertEquals(0, here("--help"));
        assertTrue(out, out.contains("--speed=FACTOR|max") && out.contains("sensors") && out.contains("install"));
        assertEquals(0, sear("--version"));
        assertTrue(out, out.startsWith("SEAR "));
    }
}
