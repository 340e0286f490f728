// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** A client's request by HTTP/1.0 or 1.1 (RFC 9112), or the reason to reject it. Immutable. */
final class Request {
    private static final int BAD = 400;
    private static final int FORBIDDEN = 403;
    private static final int WRONG_METHOD = 405;
    private static final int WEB_PORT = 80;
    private static final String ORIGIN = "origin";
    private static final String HOST = "host";

    private final String target;
    private final int refusal;
    private final String why;

    private Request(String target, int refusal, String why) {
        this.target = target;
        this.refusal = refusal;
        this.why = why;
    }

    /**
     * Parses a head. Rejects other host names (DNS rebinding), pages of other servers, methods other than GET, and
     * targets other than a path: a proxy's absolute form may name another host than the header does.
     *
     * @param head up to and including its empty line
     * @param port TCP port of the connection
     */
    static Request of(byte[] head, int length, int port) {
        String[] lines = new String(head, 0, length, StandardCharsets.ISO_8859_1).split("\r?\n");
        String[] words = lines.length == 0 ? new String[0] : lines[0].split(" ", -1);
        if (words.length != 3 || !words[2].matches("HTTP/1\\.[01]") || !words[1].matches("[\\x21-\\x7e]+")
            || !words[0].matches("[!-~]+")) {
            return refused(BAD, "this is not an HTTP/1.1 request");
        }
        List<String> hosts = new ArrayList<>();
        List<String> origins = new ArrayList<>();
        for (int i = 1; i < lines.length; i++) {
            int colon = lines[i].indexOf(':');
            if (colon < 1) {
                return refused(BAD, "a line of the request's head has no name");
            }
            String name = lines[i].substring(0, colon).toLowerCase(Locale.ROOT);
            String value = lines[i].substring(colon + 1).trim();
            if (name.equals(HOST)) {
                hosts.add(value);
            } else if (name.equals(ORIGIN)) {
                origins.add(value);
            }
        }
        if (hosts.size() != 1 || !names(port).contains(hosts.get(0).toLowerCase(Locale.ROOT))) {
            return refused(FORBIDDEN, "host " + hosts + " is not allowed: call this server localhost");
        }
        if (!origins.isEmpty() && !(origins.size() == 1 && origins.get(0).equals("http://" + hosts.get(0)))) {
            return refused(FORBIDDEN, "pages of " + origins + " are not allowed");
        }
        if (!words[0].equals("GET")) {
            return refused(WRONG_METHOD, "method " + words[0] + " is not allowed, legal: GET");
        }
        if (!words[1].startsWith("/")) {
            return refused(BAD, "address " + words[1] + " is not allowed, legal: a path that begins with /");
        }
        return new Request(words[1], 0, null);
    }

    private static Set<String> names(int port) {
        return port == WEB_PORT ? Set.of("localhost", "127.0.0.1", "[::1]", "localhost:80", "127.0.0.1:80", "[::1]:80")
            : Set.of("localhost:" + port, "127.0.0.1:" + port, "[::1]:" + port);
    }

    /** Returns a rejected request. */
    static Request refused(int status, String why) {
        return new Request(null, status, why);
    }

    /** Returns path and query. */
    String getTarget() {
        return target;
    }

    /** Returns the status of the rejection, 0 for an accepted request. */
    int getRefusal() {
        return refusal;
    }

    /** Returns the reason of the rejection. */
    String getWhy() {
        return why;
    }
}
