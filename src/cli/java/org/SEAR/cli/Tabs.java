// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import org.myrobotlab.embedded.web.Address;
import org.myrobotlab.embedded.web.Token;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.WebGui;

/** The tabs in the browser. */
final class Tabs {
    private static final String NAME = "webgui";
    /** Number of ports to try from the wanted one on. */
    private static final int MAX_TRIES = 100;

    private Tabs() {
    }

    /** Returns whether callers need a token. */
    static boolean asksForToken() {
        return Token.current().isAskedFor();
    }

    /**
     * Serves the tabs on a port, or on the next free one, and prints the address. Writes a new token to a file of the
     * user.
     *
     * @param isKnown whether port and token were announced already: then no other port is tried
     * @return the address; null on failure, which has been reported
     */
    static String start(int wanted, boolean isKnown, PrintWriter err) {
        int port = isKnown ? wanted : free(wanted);
        WebGui webGui = (WebGui) Runtime.create(NAME, "WebGui");
        webGui.setPort(port);
        Runtime.start(NAME);
        if (!webGui.isStarted()) {
            return null;
        }
        Token token = Token.current();
        String address = Address.current().url(port) + "/"
            + (token.isAskedFor() && !isKnown ? "?token=" + token.text() : "");
        err.println((port == wanted ? "" : "Port " + wanted + " is in use by another program. ")
            + "Open this in a browser:");
        err.println(address);
        if (token.isAskedFor() && !isKnown) {
            keep(token, port, err);
        }
        if (!Address.current().isLoopback()) {
            err.println("Other computers can reach this address. The connection is not encrypted: see "
                + "docs/classroom.md.");
        }
        err.flush();
        return address;
    }

    private static int free(int wanted) {
        for (int port = wanted; port < wanted + MAX_TRIES && port <= MrlRun.HIGHEST_PORT; port++) {
            try (ServerSocket probe = new ServerSocket()) {
                probe.bind(Address.current().socket(port));
                return port;
            } catch (IOException e) {
                continue;
            }
        }
        return wanted;
    }

    private static void keep(Token token, int port, PrintWriter err) {
        try {
            Path file = token.write(port);
            err.println("token: " + file + " contains it for programs, which send it as Authorization: Bearer TOKEN");
            java.lang.Runtime.getRuntime().addShutdownHook(new Thread(() -> delete(file), "token"));
        } catch (IOException e) {
            err.println("token: the file could not be written: " + e.getMessage());
        }
    }

    private static void delete(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException e) {
            System.err.println("sear: " + file + " could not be deleted: " + e.getMessage());
        }
    }
}
