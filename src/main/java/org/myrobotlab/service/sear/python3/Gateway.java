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
 * The door for Python 3 programs of the same machine (Py4J): whoever has the token calls whatever Java has. It listens on loopback only, and the
 * token of 192 random bits stands in a file that only its user can read, {@code .sear/gateway-PORT} of the home folder. Any thread.
 */
public final class Gateway implements AutoCloseable {
    /** Where Py4J's clients look by themselves. */
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
     * Opens the door.
     *
     * @param wanted port, 0 for any that is free
     * @throws IllegalArgumentException if it is no port
     * @throws IOException if it is taken, or the token can't be written
     */
    public static Gateway open(int wanted) throws IOException {
        if (wanted < 0 || wanted > HIGHEST) {
            throw new IllegalArgumentException("port is " + wanted + ", legal: 1 to " + HIGHEST + ", or 0 for one that is free");
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
            throw new IOException("port " + port + " for Python 3 can't be had: another program has it", e);
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
        Path part = Files.createTempFile(folder, "gateway", null);    // which only its user can read
        Files.write(part, (token + "\n").getBytes(StandardCharsets.UTF_8));
        return Files.move(part, folder.resolve("gateway-" + port), StandardCopyOption.REPLACE_EXISTING);
    }

    /** Where it listens. */
    public int getPort() {
        return port;
    }

    /** Closes the door; calls that run come to their end. */
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
