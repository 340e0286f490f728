// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.python3;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.SEAR.Needs;
import org.SEAR.Slow;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** Signals end Python programs with SEAR inside as they end plain ones, and links of exports go with the program. */
@Category(Slow.class)
@Needs({"installDist", "python3", "gymnasium"})
public class SignalsTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String PACKAGES = String.join(File.pathSeparator, ROOT.resolve("python/src").toString(),
        System.getProperty("sear.python3"), System.getProperty("sear.gymnasium"));
    private static final String HOME =
        System.getProperty("sear.home.built", ROOT.resolve("build/install/sear").toString());
    private static final long PATIENCE_MINUTES = 4;
    private static final Map<String, Integer> SIGNALS = Map.of("INT", 2, "TERM", 15, "HUP", 1);
    /** As a shell reports the end by a signal, and Java does. */
    private static final int BY_SIGNAL = 128;
    private static final String START = String.join("\n",
        "import os, signal, sys, threading, time",
        "import sear",
        "sear.start(headless=True, speed=%s)",
        "from sear import *",
        "robots = Runtime.start('robots', 'SEAR')",
        "robots.newProject()",
        "Floor('ground', 10, 10)",
        "Robots.rover('rover').addComponent(GPS('receiver', 52, 10, 0, '/dev/uart', '/dev/receiver'))",
        "robots.startSimulation()",
        "");
    private static final String EXPORT = "robots.exportPort('/dev/receiver', 'link')\n";
    private static final String READY = "print('ready', flush=True)\n";
    private static final String MAX = "'max'";

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();
    private Path folder;

    /** Sends a signal to a program that has printed a line. Returns the program's status. */
    private int end(String signal, String... words) throws IOException, InterruptedException {
        folder = temporary.newFolder().toPath();
        File errors = folder.resolve("errors.txt").toFile();
        // a shell starts background commands with SIGINT ignored, and nohup ignores SIGHUP
        List<String> command = new ArrayList<>(List.of("env", "--default-signal=INT,TERM,HUP", "python3"));
        command.addAll(List.of(words));
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectError(errors);
        builder.environment().put("PYTHONPATH", PACKAGES);
        builder.environment().put("SEAR_HOME", HOME);
        Process process = builder.start();
        try {
            BufferedReader printed =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
            String line = printed.readLine();
            assertTrue(line + "\n" + Files.readString(errors.toPath()), line != null);
            String[] kill = {"kill", "-" + signal, String.valueOf(process.pid())};
            assertEquals(0, new ProcessBuilder(kill).start().waitFor());
            assertTrue("SIG" + signal + " has not ended it:\n" + Files.readString(errors.toPath()),
                process.waitFor(PATIENCE_MINUTES, TimeUnit.MINUTES));
        } finally {
            process.destroyForcibly();
        }
        String[] crashes = folder.toFile().list((where, name) -> name.startsWith("hs_err"));
        assertArrayEquals(new String[0], crashes);
        return process.exitValue();
    }

    private void endsBySignals(String... words) throws IOException, InterruptedException {
        for (Map.Entry<String, Integer> signal : SIGNALS.entrySet()) {
            String what = signal.getKey() + " for " + words[words.length - 1];
            assertEquals(what, BY_SIGNAL + signal.getValue(), end(signal.getKey(), words));
            assertTrue(what, Files.notExists(folder.resolve("link"), LinkOption.NOFOLLOW_LINKS));
        }
    }

    private static String program(String speed, String code) {
        return String.format(START, speed) + EXPORT + READY + code;
    }

    @Test
    public void aProgramThatWaitsInPython() throws Exception {
        endsBySignals("-c", program("1", "time.sleep(100000)"));
        endsBySignals("-c", program("1", "threading.Event().wait()"));
    }

    @Test
    public void aProgramThatWaitsForSimulatedTime() throws Exception {
        endsBySignals("-c", program("1", "robots.simSleep(100000)"));
        endsBySignals("-c", program(MAX, "robots.simSleep(1e9)"));
        endsBySignals("-c", program(MAX, "robots.step(2000000000)"));
    }

    @Test
    public void aProgramThatComputes() throws Exception {
        endsBySignals("-c", program(MAX, "while True: pass"));
        endsBySignals("-c", program(MAX, "while True: robots.simSleep(0.1)"));
    }

    @Test
    public void aProgramWithoutExports() throws Exception {
        endsBySignals("-c", String.format(START, MAX) + READY + "robots.simSleep(1e9)");
    }

    @Test
    public void anEnvironmentOfGymnasium() throws Exception {
        String maze = ROOT.resolve("examples/maze.sear").toString();
        endsBySignals("-c", "from sear.gym import SearEnv\nenv = SearEnv('" + maze + "')\n"
            + "env.reset(seed=1)\n" + READY + "while True:\n    end = env.step(env.action_space.sample())\n"
            + "    if end[2] or end[3]: env.reset()");
    }

    /** Its first bytes, which end with a line here, say that it waits for runs. */
    @Test
    public void aProcessOfASweep() throws Exception {
        endsBySignals("-c", "import sys, threading\nfrom sear.sweeps import _child\nsys.argv[1:] = ['function']\n"
            + "answer = _child._answer\n"
            + "def first(answers, what):\n    answers.write(b'ready\\n')\n    answer(answers, what)\n"
            + "_child._answer = first\n_child.main()");
    }

    /** The program decides what its own handlers do, set before or after the start, also during a wait in Java. */
    @Test
    public void ownHandlersRunImmediately() throws Exception {
        String handlers = "def handle(number, frame):\n    raise SystemExit(number + 50)\n"
            + "for one in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP): signal.signal(one, handle)\n";
        for (Map.Entry<String, Integer> signal : SIGNALS.entrySet()) {
            assertEquals(50 + signal.getValue(),
                end(signal.getKey(), "-c", "import signal\n" + handlers + program(MAX, "robots.simSleep(1e9)")));
            assertTrue(Files.notExists(folder.resolve("link"), LinkOption.NOFOLLOW_LINKS));
            String later = String.format(START, "1") + EXPORT + handlers + READY + "robots.simSleep(100000)";
            assertEquals(50 + signal.getValue(), end(signal.getKey(), "-c", later));
            assertTrue(Files.notExists(folder.resolve("link"), LinkOption.NOFOLLOW_LINKS));
        }
    }

    /** Ctrl+C ends calls of Java other than simSleep and step, after which the program and Java go on. */
    @Test
    public void otherCallsOfJavaAreInterrupted() throws Exception {
        String call = String.format(START, MAX) + String.join("\n",
            "java = sear.java_class('java.lang.Thread')",
            "main = java.currentThread()",
            "def report():",
            "    while str(main.getState()) != 'TIMED_WAITING': time.sleep(0.01)",
            "    time.sleep(0.3)     # so that the call is no reaction to the signal",
            "    print('ready', flush=True)",
            "threading.Thread(target=report, daemon=True).start()",
            "");
        assertEquals(BY_SIGNAL + 2, end("INT", "-c", call + "java.sleep(10**9)"));
        assertEquals(0, end("INT", "-c", call + String.join("\n",
            "try:",
            "    java.sleep(10**9)",
            "except KeyboardInterrupt:",
            "    robots.step(1)",
            "    java.sleep(1)",
            "    sys.exit(0)",
            "sys.exit(3)")));
    }

    /** A wait goes on after a handler that returns. */
    @Test
    public void aHandlerThatReturnsDoesNotShortenAWait() throws Exception {
        assertEquals(0, end("TERM", "-c", program(MAX, "").replace(READY, "")
            + "seen = []\nsignal.signal(signal.SIGTERM, lambda *some: seen.append(robots.getTime()))\n"
            + "before = robots.getTime()\n" + READY + "while not seen: robots.simSleep(100)\n"
            + "passed = (robots.getTime() - before) % 100\nassert min(passed, 100 - passed) < 0.001, passed\n"));
    }

    /** Java does not run in it, but its handlers would swallow the signal. */
    @Test
    public void aForkedProcess() throws Exception {
        assertEquals(0, end("CONT", "-c", program(MAX, "child = os.fork()\nif child == 0:\n    signal.pause()\n"
            + "os.kill(child, signal.SIGTERM)\nassert os.WTERMSIG(os.waitpid(child, 0)[1]) == signal.SIGTERM\n")));
    }

    @Test
    public void theLinkGoesAtTheEndOfTheProgramToo() throws Exception {
        assertEquals(0, end("CONT", "-c", program(MAX, "assert os.path.islink('link')")));
        assertTrue(Files.notExists(folder.resolve("link"), LinkOption.NOFOLLOW_LINKS));
    }
}
