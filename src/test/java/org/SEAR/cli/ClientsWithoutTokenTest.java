// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.SEAR.FreePort;
import org.SEAR.Fuzz;
import org.SEAR.SearProcess;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/**
 * Hostile clients without a token at every listener of a SEAR with little memory. During each attack the simulation
 * continues, the number of threads stays bounded, and clients who may do so get their answers.
 */
public class ClientsWithoutTokenTest {
    /** Bounds the memory of the process, MB. */
    private static final int MEMORY = 200;
    private static final int PATIENCE_MILLIS = (int) TimeUnit.MINUTES.toMillis(4);
    private static final int MANY = 500;
    private static final int HUGE_CLIENTS = 200;
    private static final int HUGE = 1 << 20;
    private static final int GARBAGE = 60;
    /** Far fewer than one per hostile connection. */
    private static final int MORE_THREADS = 60;
    /** Without progress for so long, a listener takes no more bytes, milliseconds. */
    private static final long STALLED = 1000;
    /** A GPS receiver has sent it long before. */
    private static final int MOST = 1 << 16;
    private static final String SCRIPT = String.join("\n",
        "import sys",
        "from java.lang.management import ManagementFactory",
        "from org.SEAR.POJOs import Camera, Floor, GPS, Robots",
        "sear = Runtime.start('sear', 'SEAR')",
        "sear.newProject()",
        "Floor('ground', 10, 10)",
        "rover = Robots.rover('rover')",
        "for name in ('one', 'two'):",
        "    rover.addComponent(GPS(name, 52, 10, 0, '/dev/uart of ' + name, '/dev/' + name))",
        "rover.addComponent(Camera('eye'))",
        "sear.startSimulation()",
        "print 'ports: tcp %d rfc2217 %d camera %d gateway %d' % (",
        "    sear.exportTcp('/dev/one', 0), sear.exportRfc2217('/dev/two', 0),",
        "    sear.exportCamera('eye', 0), sear.startPython3(0))",
        "threads = ManagementFactory.getThreadMXBean()",
        "while sys.stdin.readline():",
        "    print 'now: %.3f %d' % (sear.getTime(), threads.getThreadCount())",
        "");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private final List<SocketChannel> hostile = new ArrayList<>();
    private final Map<String, Integer> ports = new TreeMap<>();
    private Process process;
    private BufferedReader printed;
    private Path errors;
    private String token;
    private String gatewayToken;
    private double time;
    private int threads;

    @Before
    public void start() throws Exception {
        Path home = folder.newFolder("home").toPath();
        Path script = Files.writeString(folder.newFile("script.py").toPath(), SCRIPT);
        errors = folder.newFile().toPath();
        int port = FreePort.find();
        List<String> command = SearProcess.command("-Xmx" + MEMORY + "m", "-XX:MaxDirectMemorySize=" + MEMORY / 2 + "m",
            "-XX:+ExitOnOutOfMemoryError", "-Duser.home=" + home,
            "-Dsear.project=" + folder.getRoot().toPath().resolve("SEARproject"));
        command.addAll(List.of(script.toString(), "--headless", "--token", "--port", String.valueOf(port)));
        process = new ProcessBuilder(command).directory(folder.getRoot()).redirectError(errors.toFile()).start();
        printed = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        String[] words = line("ports: ").split(" ");
        for (int i = 0; i < words.length; i += 2) {
            ports.put(words[i], Integer.valueOf(words[i + 1]));
        }
        ports.put("http", port);
        token = Files.readString(home.resolve(".sear").resolve("token-" + port)).trim();
        gatewayToken = Files.readString(home.resolve(".sear").resolve("gateway-" + ports.get("gateway"))).trim();
        now();
    }

    @After
    public void end() throws Exception {
        leave();
        process.destroyForcibly().waitFor();
    }

    private String line(String start) throws IOException {
        String line = printed.readLine();
        while (line != null && !line.startsWith(start)) {
            line = printed.readLine();
        }
        assertNotNull("SEAR has ended: " + Files.readString(errors), line);
        return line.substring(start.length());
    }

    /** Asks the script, which runs in SEAR's process. */
    private void now() throws IOException {
        process.getOutputStream().write('\n');
        process.getOutputStream().flush();
        String[] words = line("now: ").split(" ");
        time = Double.parseDouble(words[0]);
        threads = Integer.parseInt(words[1]);
    }

    private void leave() throws IOException {
        for (SocketChannel one : hostile) {
            one.close();
        }
        hostile.clear();
    }

    private SocketChannel connect(String listener) throws IOException {
        SocketChannel channel = SocketChannel.open(new InetSocketAddress("127.0.0.1", ports.get(listener)));
        hostile.add(channel);
        return channel;
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    /** Returns the legal beginning of a client's bytes, after which hostile ones go on as they like. */
    private static byte[] beginning(String listener) {
        return bytes(Map.of("gateway", "A\n", "rfc2217", "\377\372", "tcp", "$")
            .getOrDefault(listener, "GET / HTTP/1.1\r\nX: "));
    }

    /**
     * Sends all bytes, or as many as the listener takes. A closed connection is a legal answer.
     *
     * @return whether the listener has taken all bytes of any client
     */
    private static boolean send(List<SocketChannel> clients, byte[] what) throws IOException {
        boolean taken = false;
        try (Selector selector = Selector.open()) {
            for (SocketChannel client : clients) {
                client.configureBlocking(false);
                client.register(selector, SelectionKey.OP_WRITE, ByteBuffer.wrap(what));
            }
            while (!selector.keys().isEmpty() && selector.select(STALLED) > 0) {
                for (SelectionKey key : selector.selectedKeys()) {
                    try {
                        ((SocketChannel) key.channel()).write((ByteBuffer) key.attachment());
                        if (!((ByteBuffer) key.attachment()).hasRemaining()) {
                            taken = true;
                            key.cancel();
                        }
                    } catch (IOException e) {
                        key.cancel();
                    }
                }
                selector.selectedKeys().clear();
                selector.selectNow();
            }
        }
        return taken;
    }

    /** An attack on one listener; its connections stay open. */
    private interface Attack {
        void on(String listener) throws IOException;
    }

    private void eachListener(String name, Attack attack) throws IOException {
        attack(ports.keySet(), name, attack);
    }

    private void attack(Set<String> listeners, String name, Attack attack) throws IOException {
        for (String listener : listeners) {
            try {
                double before = time;
                int threadsBefore = threads;
                attack.on(listener);
                now();
                assertTrue(threads + " threads, " + threadsBefore + " before", threads <= threadsBefore + MORE_THREADS);
                servesOthers();
                do {
                    now();
                } while (time <= before);
                leave();
            } catch (IOException | AssertionError e) {
                throw new IOException(name + " clients of " + listener + ": " + Files.readString(errors), e);
            }
        }
    }

    private Socket other(String listener) throws IOException {
        Socket socket = new Socket("127.0.0.1", ports.get(listener));
        socket.setSoTimeout(PATIENCE_MILLIS);
        return socket;
    }

    /** Sends a request and waits for an answer, which other bytes may precede. */
    private void answers(String listener, String answer, String request) throws IOException {
        try (Socket socket = other(listener)) {
            socket.getOutputStream().write(bytes(request));
            InputStream in = socket.getInputStream();
            StringBuilder received = new StringBuilder();
            while (received.indexOf(answer) < 0) {
                int next = in.read();
                received.append((char) next);
                assertTrue(listener + " has answered " + received, next >= 0 && received.length() < MOST);
            }
        }
    }

    /** Clients of each listener that do as they should are answered. */
    private void servesOthers() throws IOException {
        answers("http", "HTTP/1.1 200", "GET / HTTP/1.1\r\nHost: localhost:" + ports.get("http")
            + "\r\nAuthorization: Bearer " + token + "\r\n\r\n");
        answers("camera", "HTTP/1.1 200",
            "GET /image.jpg HTTP/1.1\r\nHost: localhost:" + ports.get("camera") + "\r\n\r\n");
        answers("gateway", "!yv\n!ysorg.myrobotlab.service.sear.python3.Members\n",
            "A\n" + gatewayToken + "\nc\nt\ngetName\ne\n");
        answers("tcp", "$GP", "");
        answers("rfc2217", "\377\375\54", "\377\373\54");
    }

    @Test
    public void idleClientsCostNothing() throws Exception {
        eachListener("idle", listener -> {
            for (int i = 0; i < MANY; i++) {
                connect(listener);
            }
        });
    }

    @Test
    public void slowClientsCostNothing() throws Exception {
        eachListener("slow", listener -> {
            for (int i = 0; i < MANY; i++) {
                connect(listener);
            }
            for (byte one : beginning(listener)) {
                send(hostile, new byte[] {one});
            }
        });
    }

    @Test
    public void hugeRequestsCostLittleMemory() throws Exception {
        eachListener("huge", listener -> {
            byte[] huge = Arrays.copyOf(beginning(listener), HUGE);
            Arrays.fill(huge, beginning(listener).length, HUGE, (byte) 'x');
            for (int i = 0; i < HUGE_CLIENTS; i++) {
                connect(listener);
            }
            send(hostile, huge);
        });
    }

    @Test
    public void webSocketsAndBodiesWithoutATokenCostLittleMemory() throws Exception {
        String host = "Host: localhost:" + ports.get("http") + "\r\n";
        String upgrade = "GET /api/messages HTTP/1.1\r\n" + host + "Origin: http://localhost:" + ports.get("http")
            + "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
            + "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
        String call = "POST /api/service/sear/getTime HTTP/1.1\r\n" + host
            + "Content-Type: application/json\r\nContent-Length: ";
        String login = "POST /login HTTP/1.1\r\n" + host;
        for (String head : List.of(upgrade, call + HUGE + "\r\n\r\n", login + "Content-Length: 999\r\n\r\n",
                login + "Transfer-Encoding: chunked\r\n\r\nfffff\r\n")) {
            byte[] huge = Arrays.copyOf(bytes(head), HUGE);
            attack(Set.of("http"), head, listener -> {
                for (int i = 0; i < HUGE_CLIENTS; i++) {
                    connect(listener);
                }
                send(hostile, huge);
            });
        }
    }

    /** One first line of 66 MB has ended a simulation. */
    @Test
    public void oneEndlessLineIsCutOff() throws Exception {
        byte[] part = new byte[1 << 20];
        Arrays.fill(part, (byte) 'A');
        eachListener("endless", listener -> {
            connect(listener);
            int sent = 0;
            while (sent < 66 && send(hostile, part)) {
                sent++;
            }
        });
    }

    @Test
    public void malformedRequestsAndWrongTokensAreRefused() throws Exception {
        Random random = new Random(Fuzz.SEED);
        eachListener("malformed", listener -> {
            for (int i = 0; i < GARBAGE; i++) {
                byte[] garbage = new byte[random.nextInt(2000)];
                random.nextBytes(garbage);
                SocketChannel client = connect(listener);
                send(List.of(client), i % 3 == 0 ? beginning(listener) : new byte[0]);
                send(List.of(client), garbage);
                client.socket().setSoLinger(i % 2 == 0, 0);
                client.close();
            }
        });
        for (int i = 0; i < GARBAGE; i++) {
            answers("gateway", "!x\n", "A\nwrong" + i + "\n");
        }
        servesOthers();
    }
}
