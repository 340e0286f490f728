package org.myrobotlab.service.sear.python3;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.security.SecureRandom;
import java.util.Base64;
import py4j.ClientServer;
import py4j.Py4JNetworkException;

/**
 * The gateway for Python 3 programs on the same machine (Py4J). A program with the token can call all of Java. Listens
 * on loopback only. The token of 192 random bits is in {@code .sear/gateway-PORT} of the home folder, readable only by
 * its user. Any thread.
 */
public final class Gateway implements AutoCloseable {
    /** Default port of Py4J's clients. */
    public static final int PORT = 25333;
    private static final int HIGHEST = 65535;
    private static final int TOKEN_BYTES = 24;
    private static final SecureRandom RANDOM = new SecureRandom();

    private final int port;
    private final Path file;
    private final ClientServer server;

    private Gateway(int port, Path file, ClientServer server) {
        this.port = port;
        this.file = file;
        this.server = server;
    }

    /**
     * Opens a gateway.
     *
     * @param wanted port, 0 for any free one
     * @throws IllegalArgumentException if the port is out of range
     * @throws IOException if the port is in use, or the token can't be written
     */
    public static Gateway open(int wanted) throws IOException {
        if (wanted < 0 || wanted > HIGHEST) {
            throw new IllegalArgumentException("port is " + wanted + ", legal: 1 to " + HIGHEST + ", or 0 for any free one");
        }
        int port = wanted == 0 ? free() : wanted;
        byte[] random = new byte[TOKEN_BYTES];
        RANDOM.nextBytes(random);
        String token = Base64.getUrlEncoder().withoutPadding().encodeToString(random);
        ClientServer server = new ClientServer.ClientServerBuilder().javaAddress(InetAddress.getLoopbackAddress()).javaPort(port)
            .authToken(token).entryPoint(Members.class).build();
        try {
            server.startServer(true);
        } catch (Py4JNetworkException e) {
            throw new IOException("port " + port + " for Python 3 is not available: another program uses it", e);
        }
        return new Gateway(port, write(port, token), server);
    }

    private static int free() throws IOException {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return socket.getLocalPort();
        }
    }

    private static Path write(int port, String token) throws IOException {
        Path folder = Files.createDirectories(Paths.get(System.getProperty("user.home"), ".sear"));
        Path part = Files.createTempFile(folder, "gateway", null);    // only its user can read this file
        Files.write(part, (token + "\n").getBytes(StandardCharsets.UTF_8));
        return Files.move(part, folder.resolve("gateway-" + port), StandardCopyOption.REPLACE_EXISTING);
    }

    public int getPort() {
        return port;
    }

    /** Closes the gateway; calls in progress complete. */
    @Override
    public void close() {
        server.shutdown();
        try {
            Files.deleteIfExists(file);
        } catch (IOException e) {
            file.toFile().deleteOnExit();
        }
    }
}
