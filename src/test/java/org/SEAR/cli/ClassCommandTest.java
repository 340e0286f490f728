// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.Collections;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.Callable;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.junit.After;
import org.junit.Rule;
import org.junit.rules.TemporaryFolder;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.SEAR.documents.DocBlock;
import org.SEAR.FreePort;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.myrobotlab.embedded.web.Token;

/** {@code sear class}: programs that end are started again, the others continue, and none remains at the end. */
public class ClassCommandTest {
    private static final int PATIENCE_SECONDS = 240;
    private static final String ADA = "Ada-Lovelace";
    private static final String BEN = "Ben";
    /** Size of a large file, bytes. */
    private static final int LARGE = 40 << 20;
    /** Size of a part of an upload, bytes. */
    private static final int PART = 1 << 19;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private Process process;
    private int port;

    @After
    public void end() throws InterruptedException {
        if (process != null) {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly().waitFor();
        }
    }

    private Path path(String name) {
        return folder.getRoot().toPath().resolve(name);
    }

    private void sear(String... arguments) throws IOException {
        List<String> command = SearProcess.command("-Xmx128m", "-Dfile.encoding=UTF-8");
        command.addAll(List.of(arguments));
        process = new ProcessBuilder(command).directory(folder.getRoot()).redirectErrorStream(true)
            .redirectOutput(path("out.txt").toFile()).start();
    }

    private static String command(Predicate<String> wanted) {
        List<String> commands = DocBlock.commands("docs/classroom.md", "sear class --pupils names.txt").stream()
            .filter(wanted).collect(Collectors.toList());
        assertEquals(commands.toString(), 1, commands.size());
        return commands.get(0);
    }

    private static List<String> arguments(String command) {
        String[] words = command.split(" ");
        return new ArrayList<>(List.of(words).subList(1, words.length));
    }

    /** Starts the example of the page by its command, with a free port. */
    private void startClass() throws IOException {
        Files.writeString(path("names.txt"), DocBlock.of("docs/classroom.md", "text").get(0));
        Files.writeString(path("lesson1.py"), "print 'begin'\n");
        port = FreePort.find();
        List<String> arguments = arguments(command(line -> line.contains("--script")));
        arguments.addAll(List.of("--port", String.valueOf(port), "--memory", "96"));
        sear(arguments.toArray(new String[0]));
        until("all run", () -> out().contains("All 2 are running."));
    }

    private String out() throws IOException {
        return Files.readString(path("out.txt"));
    }

    private void until(String what, Callable<Boolean> condition) throws IOException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!holds(condition)) {
            assertTrue(what + "\n" + out(), System.nanoTime() < end && process.isAlive());
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(100));
        }
    }

    private static boolean holds(Callable<Boolean> condition) {
        try {
            return condition.call();
        } catch (Exception e) {
            return false;    // not yet
        }
    }

    private String token(String pupil) throws IOException {
        return Files.readString(path("class/.tokens/" + pupil)).trim();
    }

    private HttpResponse<String> call(int number, String token, String method, String arguments)
        throws IOException, InterruptedException {
        return client().send(request(number, token, method, arguments), HttpResponse.BodyHandlers.ofString());
    }

    /** Returns a new client, because connections kept to a killed process are useless afterwards. */
    private static HttpClient client() {
        return HttpClient.newHttpClient();
    }

    private static HttpRequest request(int number, String token, String method, String arguments) {
        return HttpRequest.newBuilder(URI.create("http://localhost:" + number + "/api/service/" + method))
            .header("Content-Type", "application/json").header("Authorization", "Bearer " + token)
            .POST(HttpRequest.BodyPublishers.ofString(arguments)).build();
    }

    /** Returns whether Python runs, which starts after the port opens. */
    private boolean runsScripts(int number, String token) throws IOException, InterruptedException {
        return call(number, token, "python/exec", "[\"pass\"]").body().trim().equals("true");
    }

    private static boolean answers(int number) {
        try (Socket socket = new Socket("localhost", number)) {
            return socket.isConnected();
        } catch (IOException e) {
            return false;
        }
    }

    private ProcessHandle pupil(int number) {
        return process.children().filter(one -> commandLine(one).contains("--port\0" + number + "\0")).findFirst()
            .orElseThrow();
    }

    /** Returns the whole command line; Java's own answer ends after 4096 characters. */
    private static String commandLine(ProcessHandle one) {
        try {
            return Files.readString(Path.of("/proc", String.valueOf(one.pid()), "cmdline"));
        } catch (IOException e) {
            return "";
        }
    }

    @Test
    public void endedProgramsRestartOthersContinueAndNothingRemains() throws Exception {
        startClass();
        assertTrue(out(), out().contains("http://localhost:" + port + "/?token=" + token(ADA)));
        assertEquals("name,link\n\"Ada Lovelace\",http://localhost:" + port + "/?token=" + token(ADA)
            + "\n\"Ben\",http://localhost:" + (port + 1)
            + "/?token=" + token(BEN) + "\n", Files.readString(path("class/links.csv")));
        for (String own : new String[] {"class/links.csv", "class/.tokens/Ben"}) {
            assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(path(own))));
        }
        assertEquals("rwx------", PosixFilePermissions.toString(Files.getPosixFilePermissions(path("class"))));
        assertEquals("print 'begin'\n", Files.readString(path("class/Ben/lesson1.py")));
        assertEquals(200, call(port + 1, token(BEN), "python/isRunning", "[]").statusCode());
        assertEquals("another's token", 401, call(port + 1, token(ADA), "python/isRunning", "[]").statusCode());

        ProcessHandle ben = pupil(port + 1);
        assertTrue(pupil(port).destroyForcibly());
        String killed = "Ada Lovelace: killed, by a user or because the computer is short of memory; "
            + "restarting (1 of 5)";
        until("Ada's starts again", () -> out().contains(killed)
            && runsScripts(port, token(ADA)));
        client().sendAsync(request(port, token(ADA), "python/exec",
            "[\"x = []\\nwhile True: x.append('a' * 1000000)\"]"), HttpResponse.BodyHandlers.ofString());
        until("Ada's is out of memory", () -> out().contains("Ada Lovelace: out of memory; restarting (2 of 5)")
            && runsScripts(port, token(ADA)));
        assertTrue("Ben's goes on", ben.isAlive() && ben.pid() == pupil(port + 1).pid());

        String sleeper = "[\"import subprocess\\nsubprocess.Popen(['sleep', '600'])\\nopen('begun', 'w').close()\"]";
        until("Ben's runs scripts", () -> runsScripts(port + 1, token(BEN)));
        assertEquals(200, call(port + 1, token(BEN), "python/exec", sleeper).statusCode());
        assertTrue(Files.exists(path("class/Ben/begun")));
        List<ProcessHandle> all = process.descendants().collect(Collectors.toList());
        assertTrue("two Javas and a sleep: " + all, all.size() >= 3);
        process.destroy();
        assertTrue("it goes on", process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        for (ProcessHandle one : all) {
            one.onExit().get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        }
        assertEquals("nothing stays", "[]", all.stream().filter(ProcessHandle::isAlive).collect(Collectors.toList())
            .toString());
        try (Stream<Path> logs = Files.list(path("class/.logs"))) {
            for (Path log : logs.collect(Collectors.toList())) {
                assertFalse(Files.readString(log).contains(token(ADA)) || Files.readString(log).contains(token(BEN)));
            }
        }
    }

    @Test
    public void pupilsProgramsEndWithTheTeachersProgram() throws Exception {
        Files.writeString(path("names.txt"), "Ada\n");
        port = FreePort.find();
        List<String> arguments = arguments(command(line -> line.contains("--url")));
        arguments.addAll(List.of("--port", String.valueOf(port)));
        sear(arguments.toArray(new String[0]));
        until("it runs", () -> out().contains("All 1 are running."));
        assertTrue(out(), out().contains("https://Ada.class.example/?token=" + token("Ada")));
        ProcessHandle ada = pupil(port);
        process.destroyForcibly().waitFor();
        ada.onExit().get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        assertFalse(ada.isAlive());
    }

    @Test
    public void oneStartsAfterTheOtherEachWithTheProject() throws Exception {
        Files.writeString(path("names.txt"), "Ada\nBen\n");
        Files.copy(Path.of(System.getProperty("sear.root", "."), "examples", "line.sear"), path("begin.sear"));
        port = FreePort.find();
        sear("class", "--pupils", "names.txt", "--port", String.valueOf(port), "--memory", "96", "--project",
            "begin.sear", "--at-once", "1");
        AtomicBoolean together = new AtomicBoolean();
        until("all run", () -> {
            if (process.children().count() > 1 && !answers(port)) {
                together.set(true);
            }
            return out().contains("All 2 are running.");
        });
        assertFalse("Ben's began before Ada's was there", together.get());
        for (String pupil : new String[] {"Ada", "Ben"}) {
            until(pupil + " has the project",
                () -> Files.exists(path("class/" + pupil + "/SEARproject/robot/follower.xml")));
        }
    }

    @Test
    public void examplesAreFoundInEveryFolder() throws Exception {
        Files.writeString(path("names.txt"), "Ada\n");
        port = FreePort.find();
        sear("class", "--pupils", "names.txt", "--port", String.valueOf(port), "--memory", "96", "--project",
            "examples/line.sear");
        until("Ada has the project", () -> Files.exists(path("class/Ada/SEARproject/robot/follower.xml")));
    }

    private Path largeBundle() throws IOException {
        Path large = path("large.sear");
        byte[] noise = new byte[LARGE];
        new Random(1).nextBytes(noise);
        try (ZipFile example = new ZipFile(new File(System.getProperty("sear.root", "."), "examples/line.sear"));
                ZipOutputStream to = new ZipOutputStream(Files.newOutputStream(large))) {
            for (ZipEntry entry : Collections.list(example.entries())) {
                to.putNextEntry(new ZipEntry(entry.getName()));
                example.getInputStream(entry).transferTo(to);
            }
            to.putNextEntry(new ZipEntry("assets/noise.bin"));
            to.write(noise);
        }
        return large;
    }

    private static String upload(int index, int count, byte... part) {
        return "[\"large.sear\"," + index + "," + count + ",\"" + Base64.getEncoder().encodeToString(part) + "\"]";
    }

    /** An upload has ended a program with that memory. */
    @Test
    @Category(Slow.class)
    public void aLargeUploadIsLoadedInPartsAndRefusedAsAWhole() throws Exception {
        Files.writeString(path("names.txt"), "Ada\n");
        port = FreePort.find();
        sear("class", "--pupils", "names.txt", "--port", String.valueOf(port), "--memory", "200", "--project",
            "examples/line.sear");
        until("Ada has the project", () -> call(port, token("Ada"), "sear/getProblems", "[]").statusCode() == 200);
        byte[] bundle = Files.readAllBytes(largeBundle());
        int count = (bundle.length + PART - 1) / PART;
        for (int i = 0; i < count; i++) {
            byte[] part = Arrays.copyOfRange(bundle, i * PART, Math.min(bundle.length, (i + 1) * PART));
            HttpResponse<String> answer = call(port, token("Ada"), "sear/uploadProject", upload(i, count, part));
            assertEquals(answer.body(), 200, answer.statusCode());
        }
        assertEquals(LARGE, Files.size(path("class/Ada/SEARproject/assets/noise.bin")));
        try (Socket socket = new Socket("localhost", port)) {
            socket.getOutputStream().write(("POST /api/service/sear/uploadProject HTTP/1.1\r\nHost: localhost:" + port
                + "\r\nAuthorization: Bearer " + token("Ada")
                + "\r\nContent-Type: application/json\r\nContent-Length: " + LARGE
                + "\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
            String refusal = new String(socket.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);
            assertTrue(refusal, refusal.startsWith("HTTP/1.1 413")
                && refusal.endsWith("the arguments are longer than 12 MB\n"));
        }
        assertFalse(out(), out().contains("restarting"));
    }

    @Test
    public void programsWithTooMuchMemoryAreEnded() throws Exception {
        Files.writeString(path("names.txt"), "Ada\n");
        port = FreePort.find();
        sear("class", "--pupils", "names.txt", "--port", String.valueOf(port), "--memory", "64",
            "--total-memory", "64");
        until("Ada's is too large", () -> out()
            .matches("(?s).* Ada: used \\d+ MB with all that it has started, more than 64; restarting \\(1 of 5\\).*"));
    }

    @Test
    public void aSearForOnePupilTakesItsTokenFromAFileAndKeepsItsPort() throws Exception {
        List<String> commands = DocBlock.commands("docs/classroom.md", "sear --headless");
        assertEquals(commands.toString(), 1, commands.size());
        port = FreePort.find();
        List<String> arguments = arguments(commands.get(0).replace("8901", String.valueOf(port)));
        Token.writePrivate(path("token.txt"), "sixteen-letters-\n");
        sear(arguments.toArray(new String[0]));
        until("it runs", () -> call(port, "sixteen-letters-", "python/isRunning", "[]").statusCode() == 200);
        assertEquals(401, call(port, "sixteen-letters", "python/isRunning", "[]").statusCode());
        assertTrue(out(), out().contains("is not encrypted") && !out().contains("sixteen-letters-"));
        Process first = process;
        sear(arguments.toArray(new String[0]));
        assertTrue("another one has the port", process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertEquals(out(), 1, process.exitValue());
        assertTrue(out(), out().contains("port " + port + " is in use by another program"));
        first.destroyForcibly().waitFor();
    }

    @Test
    public void invalidArgumentsAreReportedAndNothingStarts() throws Exception {
        Files.writeString(path("names.txt"), "\uFEFFAda\n\n# nobody\nada\n../..\n" + "x".repeat(61) + "\n");
        sear("class", "--pupils", "names.txt");
        assertTrue(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertEquals(2, process.exitValue());
        assertTrue(out(), out().contains("names.txt:4: \"ada\" has the same folder as \"Ada\"")
            && out().contains("names.txt:5: \"../..\" is not a name, legal: ")
            && out().contains("names.txt:6: ") && !out().contains("names.txt:1:"));
        assertFalse(Files.exists(path("class")));
        Files.writeString(path("names.txt"), "Ada\nBen\n");
        sear("class", "--pupils", "names.txt", "--port", "65535");
        assertTrue(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertTrue(out(), out().contains("so the last of 2 pupils would get 65536, legal: 1 to 65535"));
        sear("class", "--pupils", "names.txt", "--total-memory", "255");
        assertTrue(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertTrue(out(), out().contains("--total-memory is 255, legal: 256 (--memory) or more"));
        sear("class", "--pupils", "names.txt", "--at-once", "0");
        assertTrue(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertTrue(out(), out().contains("--at-once is 0, legal: 1 or more"));
        sear("class", "--pupils", "names.txt", "--url", "http://teacher-pc");
        assertTrue(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertTrue(out(), out().contains("--url is http://teacher-pc, the same for 2 pupils, legal: with {port} or "
            + "{name} in it"));
    }
}
