// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.SEAR.FreePort;
import org.junit.rules.ExternalResource;
import org.myrobotlab.framework.Talker;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.WebGui;

/** A WebGui on a free port and a {@link Talker} named talker, with byte-level access. */
final class Server extends ExternalResource {
    /** Timeout of an answer on a busy machine; a blocked server never answers. */
    private static final int PATIENCE_MILLIS = (int) TimeUnit.SECONDS.toMillis(120);
    private static final int TEXT = 0x81;
    private static final int PING = 0x89;
    private static final String LENGTH = "Content-Length:";

    private final boolean withToken;
    private WebGui webGui;
    private Talker talker;
    private Token token;
    private int port;

    Server(boolean withToken) {
        this.withToken = withToken;
    }

    /** Returns access to a server that another program started. */
    static Server at(int port) {
        Server there = new Server(false);
        there.port = port;
        return there;
    }

    @Override
    protected void before() throws IOException {
        port = FreePort.find();
        if (withToken) {
            token = Token.require();
        }
        webGui = (WebGui) Runtime.create("webgui", "WebGui");
        webGui.setPort(port);
        webGui.getConfig().resources = List.of();
        webGui.startService();
        talker = (Talker) Runtime.start("talker", Talker.class.getName());
    }

    @Override
    protected void after() {
        Token.dismiss();
        Address.dismiss();
        Runtime.releaseAll();
    }

    int port() {
        return port;
    }

    Talker talker() {
        return talker;
    }

    Token token() {
        return token;
    }

    /** Checks that a page and a service call succeed for an unrelated program. */
    void servesOthers() throws IOException, InterruptedException {
        assertEquals(200, status("GET /", ""));
        assertEquals(200, status("POST /api/service/talker/tick", "[]", "Content-Type: application/json"));
        assertEquals("tick", talker.heard.poll(PATIENCE_MILLIS, TimeUnit.MILLISECONDS));
    }

    /** Opens a connection whose reads time out. */
    Socket connect() throws IOException {
        Socket socket = new Socket("127.0.0.1", port);
        socket.setSoTimeout(PATIENCE_MILLIS);
        return socket;
    }

    /** Opens a connection from another address of this computer, such as 127.0.0.2. */
    private Socket connect(String from) throws IOException {
        Socket socket = new Socket(InetAddress.getByName("127.0.0.1"), port, InetAddress.getByName(from), 0);
        socket.setSoTimeout(PATIENCE_MILLIS);
        return socket;
    }

    /**
     * Sends a request and returns the whole answer: status, headers and body.
     * @param from the address of this computer that sends the request
     */
    String response(String from, String request, String body, String... headers) throws IOException {
        try (Socket socket = connect(from)) {
            byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
            send(socket, head(request, headers) + "Connection: close\r\nContent-Length: " + bytes.length
                + "\r\n\r\n" + body);
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /** Returns the head of a request; a Host header in the list replaces the default one. */
    String head(String request, String... headers) {
        StringBuilder head = new StringBuilder(request).append(" HTTP/1.1\r\n");
        String all = String.join("\r\n", headers);
        if (Arrays.stream(headers).noneMatch(one -> one.startsWith("Host:"))) {
            head.append("Host: localhost:").append(port).append("\r\n");
        }
        return head.append(all).append(all.isEmpty() ? "" : "\r\n").toString();
    }

    /**
     * Sends a request and returns the status code.
     * @param request method and address, such as "GET /"
     */
    int status(String request, String body, String... headers) throws IOException {
        try (Socket socket = connect()) {
            byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
            send(socket, head(request, headers) + "Connection: close\r\nContent-Length: " + bytes.length
                + "\r\n\r\n" + body);
            return Integer.parseInt(line(socket.getInputStream()).split(" ")[1]);
        }
    }

    /** Begins a request with an incomplete body. */
    Socket begin(String request, String begun, String... headers) throws IOException {
        Socket socket = connect();
        send(socket, head(request, headers) + "\r\n" + begun);
        return socket;
    }

    /**
     * Opens a web socket.
     * @return the connection after the server's answer, or null if the server rejects it
     */
    Socket webSocket(String path, String... headers) throws IOException {
        Socket socket = connect();
        send(socket, head("GET " + path, headers) + "Connection: Upgrade\r\nUpgrade: "
            + "websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
        boolean isOpen = line(socket.getInputStream()).startsWith("HTTP/1.1 101");
        if (!isOpen) {
            socket.close();
            return null;
        }
        while (!line(socket.getInputStream()).isEmpty()) {
            continue;
        }
        return socket;
    }

    /** Opens a web socket as a page of this server. */
    Socket webSocket() throws IOException {
        return webSocket("/api/messages", "Origin: http://localhost:" + port);
    }

    static void send(Socket socket, String text) throws IOException {
        socket.getOutputStream().write(text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Returns the bytes of a frame, masked with zeros.
     * @param first FIN and kind, such as 0x81 for a whole text
     */
    static byte[] frame(int first, byte... data) {
        ByteArrayOutputStream frame = new ByteArrayOutputStream();
        frame.write(first);
        int bytesOfLength = data.length < 126 ? 0 : Long.BYTES;
        frame.write(0x80 | (bytesOfLength == 0 ? data.length : 127));
        for (int i = bytesOfLength - 1; i >= 0; i--) {
            frame.write((int) ((long) data.length >> Byte.SIZE * i));
        }
        frame.writeBytes(new byte[4]);
        frame.writeBytes(data);
        return frame.toByteArray();
    }

    /** Returns the next text from the server. */
    static String nextText(InputStream in) throws IOException {
        return new String(nextFrame(in, TEXT), StandardCharsets.UTF_8);
    }

    /**
     * Returns the data of the next frame of a kind and skips texts and pings that the server sends unasked.
     * @param first as for {@link #frame}
     */
    static byte[] nextFrame(InputStream in, int first) throws IOException {
        int kind = in.read();
        int length = in.read();
        while (kind != first && (kind == TEXT || kind == PING)) {
            data(in, length);
            kind = in.read();
            length = in.read();
        }
        if (kind != first) {
            throw new IOException("no frame " + first + ", but " + kind + " " + length);
        }
        return data(in, length);
    }

    private static byte[] data(InputStream in, int length) throws IOException {
        long size = length;
        if (length >= 126) {
            size = 0;
            for (int i = 0; i < (length == 126 ? 2 : 8); i++) {
                size = size << 8 | in.read();
            }
        }
        return in.readNBytes((int) size);
    }

    /** Returns the next text other than the list of services, which the server sends unasked. */
    static String answer(Socket page) throws IOException {
        String text = nextText(page.getInputStream());
        return text.startsWith("{\"services\":") ? answer(page) : text;
    }

    /** Returns the body of the next answer. */
    static String body(InputStream in) throws IOException {
        int length = 0;
        for (String line = line(in); !line.isEmpty(); line = line(in)) {
            length = line.startsWith(LENGTH) ? Integer.parseInt(line.substring(LENGTH.length()).trim()) : length;
        }
        return new String(in.readNBytes(length), StandardCharsets.UTF_8);
    }

    private static String line(InputStream in) throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream();
        for (int one = in.read(); one >= 0 && one != '\n'; one = in.read()) {
            line.write(one);
        }
        return line.toString(StandardCharsets.US_ASCII).trim();
    }
}
