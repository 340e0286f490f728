// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.sensors.CameraImage;

/** HTTP responses of a network camera. */
final class HttpReplies {
    private static final int OK = 200;
    private static final int NOT_FOUND = 404;
    private static final int BUSY = 503;
    private static final Map<Integer, String> REASONS = Map.of(OK, "OK", 400, "Bad Request", 403, "Forbidden",
        NOT_FOUND, "Not Found",
        405, "Method Not Allowed", 431, "Request Header Fields Too Large", BUSY, "Service Unavailable");
    private static final String TEXT = "text/plain; charset=utf-8";
    private static final String LINE = "\r\n";
    /**
     * Headers of every response: pictures change, each connection has one response, and foreign pages must not frame
     * it.
     */
    private static final String ALWAYS = "Cache-Control: no-store" + LINE + "Connection: close" + LINE
        + "X-Content-Type-Options: nosniff" + LINE + "X-Frame-Options: DENY" + LINE;

    private HttpReplies() {
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static ByteBuffer[] answer(int status, String type, String more, byte[] body) {
        String head = "HTTP/1.1 " + status + ' ' + REASONS.get(status) + LINE + ALWAYS + "Content-Type: " + type + LINE
            + "Content-Length: " + body.length + LINE + more + LINE;
        return new ByteBuffer[] {ByteBuffer.wrap(bytes(head)), ByteBuffer.wrap(body)};
    }

    /** Returns the response to a rejected request. */
    static ByteBuffer[] refusal(Request request) {
        return answer(request.getRefusal(), TEXT, "Allow: GET" + LINE, bytes(request.getWhy() + '\n'));
    }

    /** Returns the response for an unknown address. */
    static ByteBuffer[] missing(String target) {
        return answer(NOT_FOUND, TEXT, "", bytes("there is nothing at " + target + ", legal: "
            + Arrays.stream(Form.values()).map(Form::getPath).collect(Collectors.joining(", ")) + '\n'));
    }

    /**
     * Returns the response with a still.
     *
     * @param shot null if no simulation with this camera runs
     */
    static ByteBuffer[] still(String camera, Form form, EncodedFrame shot) {
        if (shot == null) {
            return answer(BUSY, TEXT, "", bytes("no simulation with a camera " + camera
                + " runs: startSimulation() first\n"));
        }
        byte[] file = shot.file(form);
        CameraImage image = shot.getImage();
        if (file == null) {
            return answer(NOT_FOUND, TEXT, "", bytes("camera " + camera + " makes pictures of kind " + image.getKind()
                + ", legal: " + Arrays.stream(Form.values()).filter(one -> one.fits(image.getKind())).map(Form::getPath)
                    .collect(Collectors.joining(", ")) + '\n'));
        }
        return answer(OK, form.getType(), time(shot), file);
    }

    /** Returns the page that shows the stream. */
    static ByteBuffer[] page(String camera) {
        String name = camera.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
        return answer(OK, Form.PAGE.getType(), "Content-Security-Policy: default-src 'none'; img-src 'self'" + LINE,
            bytes("<!DOCTYPE html>\n<html lang=\"en\">\n<title>" + name + "</title>\n<h1>" + name + "</h1>\n<img src=\""
                + Form.STREAM.getPath() + "\" alt=\"camera picture\">\n<p><a href=\"" + Form.STILL.getPath()
                    + "\">one picture</a>\n</html>\n"));
    }

    /** Returns the start of a stream. */
    static ByteBuffer[] stream(String boundary) {
        return new ByteBuffer[] {ByteBuffer.wrap(
            bytes("HTTP/1.1 " + OK + " OK" + LINE + ALWAYS + "Content-Type: multipart/x-mixed-replace;boundary="
            + boundary + LINE + LINE + "--" + boundary + LINE))};
    }

    /**
     * Returns the stream's next picture and the boundary after it, so that a reader knows immediately that the picture
     * is complete.
     */
    static ByteBuffer[] part(String boundary, EncodedFrame shot) {
        byte[] file = shot.file(Form.STREAM);
        return new ByteBuffer[] {ByteBuffer.wrap(
            bytes("Content-Type: " + Form.STILL.getType() + LINE + "Content-Length: " + file.length + LINE
            + time(shot) + LINE)), ByteBuffer.wrap(file), ByteBuffer.wrap(bytes(LINE + "--" + boundary + LINE))};
    }

    private static String time(EncodedFrame shot) {
        return "X-Timestamp: " + String.format(Locale.ROOT, "%.6f", shot.getTime()) + LINE;
    }
}
