// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;

import java.io.IOException;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** With a token configured, no call succeeds without it. */
public class TokenTest {
    private static final String JSON = "Content-Type: application/json";

    @Rule
    public final TemporaryFolder home = new TemporaryFolder();
    @Rule
    public final Server server = new Server(true);

    private int call(String... headers) throws IOException {
        return server.status("POST /api/service/talker/tick", "[]", headers);
    }

    @Test
    public void callsNeedTheToken() throws Exception {
        assertEquals(401, call(JSON));
        assertEquals(401, call(JSON, "Authorization: Bearer wrong"));
        assertEquals(401, call(JSON, "Authorization: Basic " + server.token().text()));
        assertEquals(401, server.status("GET /api/service", ""));
        assertEquals(0, server.talker().heard.size());
        assertEquals(200, call(JSON, "Authorization: Bearer " + server.token().text()));
        assertEquals("tick", server.talker().heard.take());
        assertEquals(200, server.status("GET /api/service", "", "Authorization: Bearer " + server.token().text()));
        assertEquals("pages, too", 401, server.status("GET /", ""));
        assertEquals(200, server.status("GET /", "", "Authorization: Bearer " + server.token().text()));
    }

    @Test
    public void webSocketsNeedTheToken() throws Exception {
        String origin = "Origin: http://localhost:" + server.port();
        assertNull(server.webSocket("/api/messages", origin));
        assertNull(server.webSocket("/api/messages?token=wrong", origin));
        assertNull("a token in an address gets into logs",
            server.webSocket("/api/messages?token=" + server.token().text(), origin));
        String bearer = "Authorization: Bearer " + server.token().text();
        try (Socket page = server.webSocket("/api/messages", origin, bearer)) {
            assertNotNull(page);
        }
        assertNull(server.webSocket("/api/messages", "Origin: http://evil.example", bearer));
    }

    @Test
    public void onlyItsUserCanReadTheFile() throws Exception {
        String before = System.setProperty("user.home", home.getRoot().toString());
        try {
            Path file = server.token().write(server.port());
            assertEquals(home.getRoot().toPath().resolve(".sear/token-" + server.port()), file);
            assertEquals(server.token().text() + "\n", Files.readString(file));
            assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
            Token next = Token.require();
            assertNotEquals(server.token().text(), next.text());
            assertEquals(next.text() + "\n", Files.readString(next.write(server.port())));
        } finally {
            System.setProperty("user.home", before);
        }
    }
}
