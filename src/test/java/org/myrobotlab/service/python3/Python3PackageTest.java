// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.python3;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.Needs;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** The Python 3 package {@code sear}, with Java in Python's process and over the gateway; the page docs/python3.md. */
@Category(Slow.class)
@Needs({"installDist", "python3", "numpy1"})
public class Python3PackageTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String LIBRARIES = System.getProperty("sear.python3");
    private static final String HOME = System.getProperty("sear.home.built", ROOT.resolve("build/install/sear")
        .toString());
    private static final long PATIENCE_MINUTES = 10;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private String run(List<String> command, String... modules) throws IOException, InterruptedException {
        return run(0, command, modules);
    }

    /** Returns the output of a program, which must end with this status. */
    private String run(int status, List<String> command, String... modules) throws IOException, InterruptedException {
        Path folder = temporary.newFolder().toPath();
        Files.createSymbolicLink(folder.resolve("examples"), ROOT.resolve("examples"));
        File output = temporary.newFile();
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
            .redirectOutput(output);
        builder.environment().put("PYTHONPATH", String.join(File.pathSeparator, modules));
        builder.environment().put("SEAR_HOME", HOME);
        builder.environment().put("MPLBACKEND", "agg");
        builder.environment().put("JAVA_OPTS", System.getenv("JAVA_OPTS") + " -Dsear.headless=true");
        Process process = builder.start();
        try {
            boolean ended = process.waitFor(PATIENCE_MINUTES, TimeUnit.MINUTES);
            assertTrue("it has not ended:\n" + Files.readString(output.toPath()), ended);
        } finally {
            process.destroyForcibly();
        }
        assertEquals(Files.readString(output.toPath()), status, process.exitValue());
        return Files.readString(output.toPath());
    }

    /** Runs a script in Python's process. */
    private String inProcess(Path script, String... libraries) throws IOException, InterruptedException {
        List<String> modules = new ArrayList<>(List.of(libraries));
        modules.add(ROOT.resolve("python/src").toString());
        modules.add(LIBRARIES);
        return run(List.of("python3", "-c", "import sear; sear.start(headless=True, speed='max'); from sear.__main__ "
            + "import main; "
            + "import sys; sys.exit(main(sys.argv[1:]))", script.toString()), modules.toArray(new String[0]));
    }

    private List<String> sear(Path script, String... options) {
        List<String> command = SearProcess.command("-Dsear.home=" + HOME);
        command.addAll(List.of(script.toString(), "--headless", "--speed", "max", "--port", "none"));
        command.addAll(List.of(options));
        return command;
    }

    @Test
    public void callsReadingsErrorsAndCallbacksAgreeBothWays() throws Exception {
        Path script = ROOT.resolve("src/test/python3/calls.py");
        String here = inProcess(script);
        assertTrue(here, here.endsWith("False\n"));
        assertEquals(here, run(sear(script), LIBRARIES));
        assertEquals("numpy 1", here, inProcess(script, System.getProperty("sear.numpy1")));
    }

    @Test
    public void relativePathsFollowTheWorkingFolderBothWays() throws Exception {
        Path script = ROOT.resolve("src/test/python3/folders.py");
        String here = inProcess(script);
        assertTrue(here, here.endsWith("folders follow\n"));
        String there = run(sear(script, "--python3"), ROOT.resolve("python/src").toString(), LIBRARIES);
        assertTrue(there, there.endsWith("folders follow\n"));
    }

    @Test
    public void itStartsFromTheClassArchive() throws Exception {
        String classes = run(List.of("python3", "-c", "import os; os.environ['JAVA_OPTS'] += ' -Xlog:class+load'; "
            + "import sear; "
            + "sear.start(headless=True, speed='max'); sear.Runtime.start('sear', 'SEAR')"), ROOT.resolve("python/src")
                .toString(), LIBRARIES);
        assertTrue(classes, classes.contains(" org.myrobotlab.service.SEAR source: shared objects file"));
    }

    /** A copy's second start writes the archive, its next ones read it; the cache keeps five. */
    @Test
    public void aCopyHasAClassArchiveInTheCache() throws Exception {
        assertEquals("archives are bounded\n", run(List.of("python3", ROOT.resolve("src/test/python3/archives.py")
            .toString()), ROOT.resolve("python/src").toString(), LIBRARIES));
    }

    /** Examples: one measures distances, one draws, and one with a GPS receiver's driver runs by the command. */
    @Test
    public void examplesPrintTheSameInPython2And3() throws Exception {
        Path turret = ROOT.resolve("examples/drive/radar_turret.py");
        assertEquals(run(sear(turret)), inProcess(turret));
        Path waypoints = ROOT.resolve("examples/drive/gps_waypoints.py");
        assertEquals(run(sear(waypoints)), run(sear(waypoints, "--python3"), LIBRARIES));
        List<String> commands = DocBlock.commands("docs/python3.md", "sear examples/drive/maze_solver.py");
        assertEquals(1, commands.size());
        List<String> words = List.of(commands.get(0).split(" "));
        Path maze = ROOT.resolve(words.get(1));
        assertEquals(run(sear(maze)), run(sear(maze, words.subList(2, 3).toArray(new String[0])), LIBRARIES));
    }

    @Test
    public void everyExampleIsPython3() throws Exception {
        try (Stream<Path> files = Files.walk(ROOT.resolve("examples"))) {
            List<String> scripts = files.filter(file -> file.toString().endsWith(".py")).map(Path::toString).sorted()
                .collect(Collectors.toList());
            assertTrue(scripts.toString(), scripts.size() > 20);
            List<String> command = new ArrayList<>(List.of("python3", "-c",
                "import sys\nfor one in sys.argv[1:]: compile(open(one, 'rb').read(), one, 'exec')"));
            command.addAll(scripts);
            assertEquals("", run(command));
        }
    }

    @Test
    public void thePagesProgramsRun() throws Exception {
        List<String> blocks = DocBlock.of("docs/python3.md", "python3");
        assertEquals(5, blocks.size());
        String plot = inProcessAlone(blocks.get(0));
        assertEquals("", plot);
        assertEquals("1 s: 0.29 m east\n2 s: 0.59 m east\n3 s: 0.89 m east\n", inProcessAlone(blocks.get(1)));
        Path script = Files.writeString(temporary.newFile().toPath(), blocks.get(2));
        assertEquals("the nearest thing is 2.00 m away\n", run(sear(script), LIBRARIES));
        String heard = inProcessAlone(blocks.get(4));
        assertTrue(heard, heard.matches("(19|20|21) readings, the last \\d\\.\\d\\d m\n"));
    }

    @Test
    public void oneProgramAtATimeUsesAProjectFolder() throws Exception {
        assertEquals("", inProcessAlone("import os, subprocess, sys, sear\n"
            + "sear.start(headless=True)\nsear.Floor('ground', 5, 5)\n"
            + "other = 'import sear; sear.start(headless=True%s); sear.Floor(\"other\", 1, 1)'\ndef run(options):\n"
            + "    return subprocess.run([sys.executable, '-c', other % options], stderr=subprocess.PIPE, text=True)\n"
            + "refused = run('')\n"
            + "assert refused.returncode == 1 and 'in use by process %d (' % os.getpid() in refused.stderr, "
            + "refused.stderr\nmade = run(', project=\"elsewhere\"')\n"
            + "assert made.returncode == 0 and os.listdir('elsewhere/environment') == ['other.xml'], made.stderr\n"
            + "assert os.listdir('SEARproject/environment') == ['ground.xml']\n"));
    }

    /** Runs code as a separate program. */
    private String inProcessAlone(String code) throws IOException, InterruptedException {
        Path script = Files.writeString(temporary.newFile().toPath(), code);
        return run(List.of("python3", script.toString()), ROOT.resolve("python/src").toString(), LIBRARIES);
    }

    /** A Jython script opens the gateway and starts a Python 3 program, as a user would in another window. */
    @Test
    public void aProgramConnectsToARunningSimulation() throws Exception {
        List<String> blocks = DocBlock.of("docs/python3.md", "python");
        assertEquals(1, blocks.size());
        Path home = temporary.newFolder().toPath();
        Path program = Files.writeString(temporary.newFile().toPath(),
            DocBlock.of("docs/python3.md", "python3").get(3)
                .replace("connect()", "connect(int(__import__('sys').argv[1]))"));
        Path script = Files.writeString(temporary.newFile().toPath(), blocks.get(0)
            .replace("startPython3()", "startPython3(0)")
            + "import os, subprocess\nassert sear.startPython3() == port\n"
            + "files = os.listdir(" + quoted(home.resolve(".sear")) + ")\nassert files == ['gateway-%d' % "
            + "port], files\n"
            + "assert os.stat(" + quoted(home.resolve(".sear")) + " + '/' + files[0]).st_mode & 0o077 == 0\n"
            + "print subprocess.check_output(['python3', " + quoted(program) + ", str(port)]).strip()\n"
            + "sear.stopPython3()\nassert os.listdir(" + quoted(home.resolve(".sear")) + ") == []\n"
            + "print subprocess.call(['python3', " + quoted(program) + ", str(port)])\n");
        List<String> command = SearProcess.command("-Dsear.home=" + HOME, "-Duser.home=" + home);
        command.addAll(List.of(script.toString(), "--headless", "--port", "none"));
        command.add(0, "HOME=" + home);
        command.add(0, "env");
        String said = run(command, ROOT.resolve("python/src").toString(), LIBRARIES);
        assertTrue(said, said.startsWith("False\n"));
        assertTrue(said, said.contains("call sear.startPython3("));
        assertTrue(said, said.endsWith("1\n"));
    }

    private static String quoted(Path path) {
        return "'" + path + "'";
    }

    @Test
    public void anErrorEndsAScriptWithItsLineAndStatus() throws Exception {
        Path script = Files.writeString(temporary.newFile().toPath(),
            "#!/usr/bin/env python3\nsear = Runtime.start('sear', 'SEAR')\nprint('begun')\nsear.getTime()\n");
        String said = run(1, sear(script), LIBRARIES);
        assertEquals("begun\nTraceback (most recent call last):\n  File \"" + script + "\", line 4, in <module>\n    "
            + "sear.getTime()\nsear.IllegalStateException: no simulation runs: startSimulation() first\n",
                said.replaceAll("(?m)^ *[\\^~]+\n", ""));
        Files.writeString(script, "#!/usr/bin/env python3\nimport sys\nsys.exit(7)\n");
        run(7, sear(script), LIBRARIES);
        String missing = run(1, sear(script));
        assertTrue(missing, missing.contains(" lacks ") && missing.contains("-m pip install"));
    }

    /** Uses the calls of the tab's editor. */
    @Test
    public void theEditorRunsPython3AndStopsIt() throws Exception {
        Path script = Files.writeString(temporary.newFile().toPath(), String.join("\n",
            "import os, time", "from java.lang import Thread", "run = getattr(python, 'exec')",
            "first = '#!/usr/bin/env python3\\n'", "print run(first + 'print(f\"{1 + 1} by Python 3\")')",
            "print run(first + 'raise ValueError(\"so\")')",
            "print run(first + 'import time\\nopen(\"begun.txt\", \"w\").close()\\nwhile True: time.sleep(1)', False)",
            "while not os.path.exists('begun.txt'): time.sleep(0.01)",
            "print python.stop()",
            "while [one for one in Thread.getAllStackTraces().keySet() if one.getName() == 'python_script']: "
            + "time.sleep(0.01)", "print 'stopped'"));
        String said = run(sear(script), LIBRARIES);
        assertTrue(said, said.startsWith("2 by Python 3\nTrue\n"));
        assertTrue(said, said.contains("line 2, in <module>\n") && said.contains("\nValueError: so\n"));
        assertTrue(said, said.contains("False\nTrue\nTrue\n"));
        assertTrue(said, said.contains("stopped\n"));
    }

    /**
     * The sources stay as they are: nothing is written to them, so any number of builds can run. Small files stand for
     * the jars.
     */
    @Test
    public void pipBuildsTwiceAtTheSameTimeFromSourcesThatStayAsTheyAre() throws Exception {
        Path sources = temporary.newFolder().toPath();
        copy(ROOT.resolve("python"), sources.resolve("python"));
        Files.copy(ROOT.resolve("gradle.properties"), sources.resolve("gradle.properties"));
        Path built = sources.resolve("build/install/sear");
        for (String file : List.of("plugin/sear.jar", "lib/small.txt", "examples/small.txt", "LICENSES.md",
            "python/sear/__init__.pyi")) {
            Files.createDirectories(built.resolve(file).getParent());
            Files.writeString(built.resolve(file), file);
        }
        String list = "find python | sort";
        String said = run(List.of("sh", "-e", "-c", "cd " + sources + "\nchmod -R a-w python\n" + list + " >before\n"
            + "pip3 wheel -v --no-deps --disable-pip-version-check -w one ./python >one.log 2>&1 & first=$!\n"
            + "pip3 wheel -q --no-deps --disable-pip-version-check -w two ./python\nwait $first\n" + list + " >after\n"
            + "cmp before after\ncmp " + ROOT.resolve("LICENSE") + " python/LICENSE\n"
            + "ls one/sear-*.whl two/sear-*.whl | wc -l\n! grep -i deprecat one.log\nchmod -R u+w python"));
        assertEquals("2", said.trim());
    }

    /**
     * Runs the page's commands in a folder with SEAR's sources, then the page's first program with the installed
     * package.
     */
    @Test
    public void pipInstallsItWithItsJars() throws Exception {
        Path sources = temporary.newFolder().toPath();
        copy(ROOT.resolve("python"), sources.resolve("python"));
        Files.copy(ROOT.resolve("gradle.properties"), sources.resolve("gradle.properties"));
        Files.createDirectories(sources.resolve("build/install"));
        Files.createSymbolicLink(sources.resolve("build/install/sear"), Path.of(HOME));
        List<String> commands = new ArrayList<>(DocBlock.commands("docs/python3.md", "python3 -m venv"));
        commands.addAll(DocBlock.commands("docs/python3.md", "venv/bin/pip install"));
        assertEquals(2, commands.size());
        Path script = Files.writeString(sources.resolve("plot.py"), DocBlock.of("docs/python3.md", "python3").get(0)
            + "import sys\nassert sys.modules['sear'].__file__.startswith(sys.prefix), sys.modules['sear']\n");
        run(List.of("sh", "-e", "-c", "cd " + sources
            + "\nexport PIP_QUIET=1 PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_COMPILE=1\nunset SEAR_HOME\n"
            + String.join("\n", commands) + "\nln -s " + ROOT.resolve("examples") + " .\nvenv/bin/python " + script
                + "\ntest -s scan.png"));
    }

    private static void copy(Path from, Path to) throws IOException {
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : files.filter(one -> !from.relativize(one).startsWith("build") && !one.toString()
                .contains("egg-info") && !one.toString().contains("__pycache__")).collect(Collectors.toList())) {
                Files.copy(file, to.resolve(from.relativize(file).toString()));
            }
        }
    }
}
