// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.python3;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.security.SecureRandom;
import java.util.Base64;
import javax.net.ServerSocketFactory;
import javax.net.SocketFactory;
import org.myrobotlab.service.sear.tcp.TcpListener;
import py4j.ClientServer;
import py4j.GatewayServer;
import py4j.JavaServer;
import py4j.Py4JJavaServer;
import py4j.Py4JPythonClientPerThread;

/**
 * The gateway for Python 3 programs on the same machine (Py4J). A program with the token can call all of Java; a
 * {@link TokenGate} admits no other. Listens on loopback only. The token of 192 random bits is in
 * {@code .sear/gateway-PORT} of the home folder, readable only by its user. Any thread.
 */
public final class Gateway implements AutoCloseable {
    /** Default port of Py4J's clients. */
    public static final int PORT = 25333;
    private static final int TOKEN_BYTES = 24;
    private static final SecureRandom RANDOM = new SecureRandom();

    private final Path file;
    private final TokenGate gate;
    private final ClientServer server;

    private Gateway(Path file, TokenGate gate, ClientServer server) {
        this.file = file;
        this.gate = gate;
        this.server = server;
    }

    /** Py4J without its port: serves connections that the gate has admitted, each on a thread. */
    private static final class Admitted extends JavaServer {
        Admitted(Object entryPoint, Py4JPythonClientPerThread client) {
            super(entryPoint, 0, 0, 0, null, client);
        }

        void serve(Socket socket) {
            processSocket(socket);
        }
    }

    /** Py4J's parts around {@link Admitted}. Never connects to a Python program, so the addresses don't matter. */
    private static final class Calls extends ClientServer {
        Calls() {
            super(0, InetAddress.getLoopbackAddress(), GatewayServer.DEFAULT_PYTHON_PORT,
                InetAddress.getLoopbackAddress(), 0, 0,
                ServerSocketFactory.getDefault(), SocketFactory.getDefault(), Members.class, false, true);
        }

        @Override
        protected Py4JJavaServer createJavaServer(Object entryPoint, Py4JPythonClientPerThread client) {
            return new Admitted(entryPoint, client);
        }
    }

    /**
     * Opens a gateway.
     *
     * @param wanted port, 0 for any free one
     * @throws IllegalArgumentException if the port is out of range
     * @throws IOException if the port is in use, or the token can't be written
     */
    public static Gateway open(int wanted) throws IOException {
        if (wanted < 0 || wanted > TcpListener.HIGHEST_PORT) {
            throw new IllegalArgumentException("port is " + wanted + ", legal: 1 to " + TcpListener.HIGHEST_PORT
                + ", or 0 for any free one");
        }
        byte[] random = new byte[TOKEN_BYTES];
        RANDOM.nextBytes(random);
        String token = Base64.getUrlEncoder().withoutPadding().encodeToString(random);
        ClientServer server = new Calls();
        TokenGate gate;
        try {
            gate = TokenGate.open(wanted, token, ((Admitted) server.getJavaServer())::serve);
        } catch (BindException e) {
            throw new IOException("port " + wanted + " for Python 3 is not available: another program uses it", e);
        }
        try {
            return new Gateway(write(gate.getPort(), token), gate, server);
        } catch (IOException e) {
            gate.close();
            throw e;
        }
    }

    private static Path write(int port, String token) throws IOException {
        Path folder = Files.createDirectories(Paths.get(System.getProperty("user.home"), ".sear"));
        Path part = Files.createTempFile(folder, "gateway", null);    // only its user can read this file
        Files.write(part, (token + "\n").getBytes(StandardCharsets.UTF_8));
        return Files.move(part, folder.resolve("gateway-" + port), StandardCopyOption.REPLACE_EXISTING);
    }

    public int getPort() {
        return gate.getPort();
    }

    /** Closes the gateway; calls in progress complete. */
    @Override
    public void close() {
        gate.close();
        server.shutdown();
        try {
            Files.deleteIfExists(file);
        } catch (IOException e) {
            file.toFile().deleteOnExit();
        }
    }
}
