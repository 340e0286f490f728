// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** A client of a network camera with its own connection that reads HTTP byte by byte. */
final class Visitor implements AutoCloseable {
    private static final int MILLIS = 60_000;

    /** The status code, or 0 without an answer. */
    int status;
    final Map<String, String> headers = new TreeMap<>();
    private final Socket socket = new Socket();
    private final InputStream in;

    /** @param buffer of the system for its connection, bytes */
    Visitor(int port, int buffer) throws IOException {
        socket.setReceiveBufferSize(buffer);
        socket.setSoTimeout(MILLIS);
        socket.connect(new InetSocketAddress(InetAddress.getByName("127.0.0.1"), port), MILLIS);
        in = new java.io.BufferedInputStream(socket.getInputStream());
    }

    /** Opens a connection and sends a request as browsers do. */
    static Visitor at(int port, String target) throws IOException {
        Visitor visitor = new Visitor(port, 1 << 16);
        visitor.say("GET " + target + " HTTP/1.1\r\nHost: localhost:" + port + "\r\nAccept: */*\r\n\r\n");
        visitor.readHead();
        return visitor;
    }

    void say(String text) throws IOException {
        socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Closes the sending direction. */
    void stopTalking() throws IOException {
        socket.shutdownOutput();
    }

    private String line() throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream();
        for (int next = in.read(); next != '\n'; next = in.read()) {
            if (next < 0) {
                throw new EOFException(line.toString());
            }
            line.write(next);
        }
        String text = line.toString(StandardCharsets.ISO_8859_1);
        if (!text.endsWith("\r")) {
            throw new IOException("a line without a return: " + text);
        }
        return text.substring(0, text.length() - 1);
    }

    private Map<String, String> readFields(Map<String, String> fields) throws IOException {
        for (String line = line(); !line.isEmpty(); line = line()) {
            String[] parts = line.split(": ", 2);
            fields.put(parts[0].toLowerCase(Locale.ROOT), parts[1]);
        }
        return fields;
    }

    void readHead() throws IOException {
        String[] words = line().split(" ", 3);
        if (!words[0].equals("HTTP/1.1")) {
            throw new IOException("no answer of HTTP/1.1: " + words[0]);
        }
        status = Integer.parseInt(words[1]);
        readFields(headers);
    }

    /** Returns the rest, whose length must be that of the header. */
    byte[] body() throws IOException {
        byte[] body = in.readAllBytes();
        if (body.length != Integer.parseInt(headers.get("content-length"))) {
            throw new IOException(body.length + " bytes instead of " + headers.get("content-length"));
        }
        return body;
    }

    String text() throws IOException {
        return new String(body(), StandardCharsets.UTF_8).trim();
    }

    /** Counts all bytes until the other side closes. */
    int rest() throws IOException {
        int count = 0;
        byte[] some = new byte[1 << 16];
        for (int read = in.read(some); read >= 0; read = in.read(some)) {
            count += read;
        }
        return count;
    }

    /** Returns a stream's next picture. */
    Part part() throws IOException {
        String boundary = headers.get("content-type").replaceFirst(".*boundary=", "");
        String line = line();
        line = line.isEmpty() ? line() : line;
        if (!line.equals("--" + boundary)) {
            throw new IOException("no boundary: " + line);
        }
        Map<String, String> fields = readFields(new TreeMap<>());
        byte[] file = in.readNBytes(Integer.parseInt(fields.get("content-length")));
        return new Part(fields.get("content-type"), Double.parseDouble(fields.get("x-timestamp")), file);
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }

    /** One picture of a stream. */
    static final class Part {
        final String type;
        final double time;
        final byte[] file;

        Part(String type, double time, byte[] file) {
            this.type = type;
            this.time = time;
            this.file = file;
        }
    }
}
