// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.sweep;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.SEAR.HowMany;
import org.SEAR.Needs;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** {@code sear sweep} and {@code sear.sweep} with Dask workers: programs and commands of docs/sweeps.md. */
@Category(Slow.class)
@Needs({"installDist", "python3", "gymnasium", "sweep"})
public class SweepTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String HOME = System.getProperty("sear.home.built", ROOT.resolve("build/install/sear")
        .toString());
    private static final Path PROGRAMS = ROOT.resolve("src/test/sweep");
    private static final String LIBRARIES = String.join(File.pathSeparator, System.getProperty("sear.sweep"),
        System.getProperty("sear.python3"), System.getProperty("sear.gymnasium"));
    private static final long PATIENCE_SECONDS = 600;
    private static final int ROWS = HowMany.of("sear.sweepRows", 1000);

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();
    private Path folder;
    private String said;

    @Before
    public void makeAFolder() throws IOException {
        folder = temporary.newFolder().toPath();
    }

    /**
     * Runs a command; its error output is in {@link #said}.
     * @return its standard output
     */
    private String run(int status, String modules, List<String> command) throws IOException, InterruptedException {
        File out = temporary.newFile();
        File err = temporary.newFile();
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectOutput(out)
            .redirectError(err);
        builder.environment().put("PYTHONPATH", modules);
        builder.environment().put("SEAR_HOME", HOME);
        Process process = builder.start();
        boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        said = Files.readString(err.toPath());
        assertTrue("it has not ended:\n" + said, ended);
        assertEquals(said, status, process.exitValue());
        return Files.readString(out.toPath());
    }

    private String sear(int status, String... arguments) throws IOException, InterruptedException {
        List<String> command = SearProcess.command("-Dsear.home=" + HOME);
        command.addAll(List.of(arguments));
        return run(status, LIBRARIES, command);
    }

    private String python(Path program, String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("python3", program.toString()));
        command.addAll(List.of(arguments));
        return run(0, String.join(File.pathSeparator, ROOT.resolve("python/src").toString(), PROGRAMS.toString(),
            LIBRARIES), command);
    }

    /** Runs the page's Jython script, aborts and resumes it, and repeats one of its rows. */
    @Test
    public void aJythonScriptIsSweptResumedAndRepeatedIdentically() throws Exception {
        Path script = folder.resolve("ahead.py");
        List<String> blocks = DocBlock.of("docs/sweeps.md", "python");
        assertEquals(1, blocks.size());
        Files.writeString(script, blocks.get(0));
        List<String> commands = DocBlock.commands("docs/sweeps.md", "sear sweep ahead.py --seeds");
        assertEquals(1, commands.size());
        String[] words = commands.get(0).replace("--seeds 1000", "--seeds 2")
            .replace("0.1:0.5:5", "0.2:0.4:2 --workers 1").substring("sear ".length()).split(" ");
        assertEquals("4 rows in ahead-sweep: 4 ok\n", sear(0, words));
        Path table = folder.resolve("ahead-sweep/rows.csv");
        List<String> rows = Files.readAllLines(table);
        assertTrue(rows.get(0), rows.get(0).startsWith("row,seed,speed,ahead,status,message,version,digest"));
        assertTrue(rows.get(3), rows.get(3).matches("2,1,0\\.4,\\d\\.\\d+,ok,,\\d.*\\+[0-9a-f]{8},[0-9a-f]{64}"));
        byte[] bytes = Files.readAllBytes(table);
        byte[] columns = Files.readAllBytes(folder.resolve("ahead-sweep/rows.parquet"));

        Path journal = folder.resolve("ahead-sweep/journal.jsonl");
        List<String> lines = Files.readAllLines(journal);
        Files.writeString(journal, String.join("\n", lines.subList(0, 3)) + "\n" + lines.get(3).substring(0, 20));
        Files.delete(table);
        sear(0, words);
        assertTrue(said, said.contains("3 of 4 rows exist already"));
        assertTrue("the same bytes when it has gone on", java.util.Arrays.equals(bytes, Files.readAllBytes(table))
            && java.util.Arrays.equals(columns, Files.readAllBytes(folder.resolve("ahead-sweep/rows.parquet"))));

        String[] again = DocBlock.commands("docs/sweeps.md", "sear sweep ahead.py --again").get(0)
            .replace("--again 17", "--again 3").substring("sear ".length()).split(" ");
        sear(0, again);
        assertTrue(said, said.contains("row 3 is identical to the byte"));
        Files.writeString(journal, Files.readString(journal).replace("\"ahead\": ", "\"ahead\": 1"));
        sear(1, again);
        assertTrue(said, said.contains("row 3 differs: ahead was 1"));
        Files.writeString(script, "# another\n" + blocks.get(0));
        sear(2, words);
        assertTrue(said, said.contains("ahead-sweep has the rows of another sweep, with another digest"));
    }

    /**
     * A Python 3 script that fails, never ends, kills its process or takes too much memory costs one row, which names
     * the cause.
     */
    @Test
    public void aFailureCostsOneRow() throws Exception {
        Path script = folder.resolve("wrong.py");
        Files.writeString(script, String.join("\n", "#!/usr/bin/env python3", "import os, signal",
            "sear = Runtime.start('sear', 'SEAR')",
            "kind = sear.getParameter('kind', 'good')", "while kind == 'endless': sleep(0.1)", "if kind == 'dies':",
            "    os.kill(os.getpid(), signal.SIGKILL)",
            "if kind == 'parent': os.kill(os.getppid(), signal.SIGTERM)",
            "if kind == 'group': os.killpg(0, signal.SIGKILL)",
            "while kind == 'parent': sleep(0.1)", "if kind == 'greedy':", "    much = b'x' * 1500000000",
            "    while True: sleep(0.1)",
            "if kind == 'fails':", "    sear.loadProject('nowhere.sear')", "if kind == 'escapes':",
            "    raise ValueError('\\x1b[31mred')", "sear.setResult('answer', 42)",
            "sear.setResult('big', kind == 'good')"));
        String out = sear(1, "sweep", "wrong.py", "--set",
            "kind=good,endless,dies,greedy,fails,escapes,parent,group", "--set", "knd=1", "--workers", "2",
            "--limit", "20", "--memory", "1200", "--out", "out");
        assertEquals("8 rows in out: 1 ok, 3 died, 2 failed, 1 memory, 1 time\n", out);
        assertTrue(said, said.contains("row 0 has not used parameter knd: does the script pass this name to "
            + "sear.getParameter?\n"));
        assertTrue(said, said.contains("\ndied: row 2: the run's process was ended by SIGKILL\n"));
        List<String> rows = Files.readAllLines(folder.resolve("out/rows.csv")).stream()
            .map(row -> row.replaceFirst(",[^,]*,[^,]*$", "")).collect(Collectors.toList());
        assertEquals("row,seed,kind,knd,answer,big,status,message", rows.get(0));
        assertEquals("0,1,good,1,42,true,ok,", rows.get(1));
        assertEquals("1,1,endless,1,,,time,the run took longer than 20 s", rows.get(2));
        assertEquals("2,1,dies,1,,,died,the run's process was ended by SIGKILL", rows.get(3));
        assertEquals("3,1,greedy,1,,,memory,the run's process used more than 1200 MB", rows.get(4));
        assertTrue(rows.get(5), rows.get(5).startsWith("4,1,fails,1,,,failed,") && rows.get(5).contains("line 15: ")
            && rows.get(5).contains("nowhere.sear"));
        assertEquals("5,1,escapes,1,,,failed,line 17: ValueError: ?[31mred", rows.get(6));
        assertEquals("6,1,parent,1,,,died,the run's process was ended by SIGTERM", rows.get(7));
        assertEquals("7,1,group,1,,,died,the run's process was ended by SIGKILL", rows.get(8));
        sear(0, "sweep", "wrong.py", "--again", "5", "--out", "out");
        assertTrue(said, said.contains("ValueError: ?[31mred") && said.indexOf(0x1b) < 0);
    }

    /** The script of a run connects to this test and waits for ever. The other processes hold a pipe open. */
    @Test
    public void allProcessesOfASweepEndWithItsCommand() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            server.setSoTimeout((int) TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
            Files.writeString(folder.resolve("waits.py"), String.join("\n", "#!/usr/bin/env python3", "import socket",
                "socket.create_connection(('127.0.0.1', " + server.getLocalPort() + ")).recv(1)"));
            List<String> command = SearProcess.command("-Dsear.home=" + HOME);
            command.addAll(List.of("sweep", "waits.py", "--seeds", "2", "--workers", "1"));
            Path pipe = folder.resolve("pipe");
            assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
            Future<byte[]> output = CompletableFuture.supplyAsync(() -> whole(pipe));
            ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
                .redirectOutput(pipe.toFile());
            builder.environment().put("PYTHONPATH", LIBRARIES);
            builder.environment().put("SEAR_HOME", HOME);
            Process process = builder.start();
            List<ProcessHandle> all = List.of();
            try (Socket script = server.accept()) {
                all = process.descendants().collect(Collectors.toList());
                process.destroyForcibly();
                script.setSoTimeout((int) TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
                assertEquals(-1, script.getInputStream().read());
                output.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
            } finally {
                all.forEach(ProcessHandle::destroyForcibly);
                process.destroyForcibly();
            }
        }
    }

    /** Returns the content of a pipe, which ends when no process can write to it. */
    private static byte[] whole(Path pipe) {
        try (InputStream from = Files.newInputStream(pipe)) {
            return from.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    public void aKilledWorkerCostsNoRowAndTheSameSweepWritesTheSameBytes() throws Exception {
        String out = python(PROGRAMS.resolve("killed.py"), String.valueOf(ROWS), "2");
        assertEquals(ROWS + " rows, " + ROWS + " ok, one worker killed, the same to the byte\n", out);
    }

    @Test
    public void illegalArgumentsAreReported() throws Exception {
        Files.writeString(folder.resolve("script.py"), "");
        assertEquals("all refused\n", python(PROGRAMS.resolve("refused.py")));
        assertTrue(said, said.contains("sear sweep: --limit is \"-1\", legal: a number above 0\n"));
    }

    /** Runs the page's function and reads its table as the page describes. */
    @Test
    public void thePagesProgramsRun() throws Exception {
        List<String> blocks = DocBlock.of("docs/sweeps.md", "python3");
        assertEquals(2, blocks.size());
        String out = python(Files.writeString(folder.resolve("function.py"), blocks.get(0)));
        assertTrue(out, out.matches("(0\\.\\d m/s, seed \\d: \\d\\.\\d+ m\n){4}"));
        out = python(Files.writeString(folder.resolve("read.py"), blocks.get(1)));
        assertTrue(out, out.matches("(?s).*speed: double.*distance: double.*4 rows\n"));
    }

    /** Runs one of the example's runs without Dask. */
    @Test
    public void theExampleFindsTheCone() throws Exception {
        Path program = Files.writeString(folder.resolve("once.py"),
            "import sys\nsys.path.insert(0, sys.argv[1])\nimport maze_sweep\n"
            + "made = maze_sweep.drive(5, 0.3)\nprint(made['found'], made['seconds'] < 150, sorted(made))\n");
        assertEquals("True True ['bumps', 'found', 'seconds']\n",
            python(program, ROOT.resolve("examples/python3").toString()));
    }
}
