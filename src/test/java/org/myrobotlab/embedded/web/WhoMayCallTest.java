// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.Socket;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;

/** Programs of this computer and pages of this server may call services; pages of another server can't. */
public class WhoMayCallTest {
    private static final String JSON = "Content-Type: application/json";
    private static final String TICK = "/api/service/talker/tick";

    @Rule
    public final Server server = new Server(false);

    private int post(String... headers) throws IOException {
        return server.status("POST " + TICK, "[]", headers);
    }

    private String own() {
        return "http://localhost:" + server.port();
    }

    @After
    public void nothingElseWasCalled() {
        assertTrue(server.talker().heard.toString(), server.talker().heard.isEmpty());
    }

    private void ticked() throws InterruptedException {
        assertEquals("tick", server.talker().heard.take());
    }

    @Test
    public void programsAndOwnPagesCallByPostWithJson() throws Exception {
        assertEquals(200, post(JSON));
        ticked();
        assertEquals(200, post(JSON + "; charset=utf-8", "Origin: " + own(), "Sec-Fetch-Site: same-origin",
            "Sec-Fetch-Mode: cors"));
        ticked();
        String byNumber = "127.0.0.1:" + server.port();
        assertEquals(200, post(JSON, "Host: " + byNumber, "Origin: http://" + byNumber));
        ticked();
    }

    @Test
    public void formsAndBeaconsCannotCall() throws Exception {
        assertEquals(415, post());
        for (String type : new String[] {"application/x-www-form-urlencoded", "multipart/form-data; boundary=x",
            "text/plain", "text/plain; a=application/json", "application/jsonp", ""}) {
            assertEquals(type, 415, post("Content-Type: " + type));
        }
    }

    @Test
    public void otherHostsAndOriginsAreRefused() throws Exception {
        for (String origin : new String[] {"http://evil.example", "null", "https://localhost:" + server.port(),
            "http://localhost:" + (server.port() + 1),
            "http://localhost", "http://127.0.0.1:" + server.port(), own() + ".evil.example", ""}) {
            assertEquals(origin, 403, post(JSON, "Origin: " + origin));
        }
        assertEquals(403, post(JSON, "Origin: " + own(), "Origin: http://evil.example"));
        assertEquals(403, post(JSON, "Host: evil.example:" + server.port()));
        assertEquals(403, post(JSON, "Host: localhost"));
        assertEquals(403, server.status("GET /", "", "Origin: http://evil.example"));
    }

    @Test
    public void requestsOfForeignPagesAreRejected() throws Exception {
        for (String site : new String[] {"none", "cross-site", "same-site"}) {
            assertEquals(site, 403, post(JSON, "Sec-Fetch-Site: " + site));
            assertEquals(site, 403, server.status("GET /api/service", "", "Sec-Fetch-Site: " + site));
            assertNotEquals(site, 200, server.status("POST //api//service/talker/tick", "[]", JSON,
                "Sec-Fetch-Site: " + site));
        }
        assertEquals(403, server.status("GET /api/service", "", "Sec-Fetch-Site: same-origin",
            "Sec-Fetch-Mode: navigate"));
        assertEquals("links to the pages work", 200,
            server.status("GET /", "", "Sec-Fetch-Site: cross-site", "Sec-Fetch-Mode: navigate"));
    }

    @Test
    public void onlyPagesAreServedAndNoClasses() throws Exception {
        for (String file : new String[] {"Guard.class", "package-info.class", "embedded/web/Guard.class",
            "org/myrobotlab/embedded/web/Guard.class"}) {
            assertEquals(file, 404, server.status("GET /" + file, ""));
        }
        assertEquals(200, server.status("GET /mrl.js", ""));
    }

    @Test
    public void getOnlyReads() throws Exception {
        assertEquals(405, server.status("GET " + TICK, ""));
        assertEquals(405, server.status("GET /api/service/talker/half/3", ""));
        assertEquals(405, server.status("GET /api/service/talker/exec/print", ""));
        assertEquals(200, server.status("GET /api/service/talker/getName", ""));
        assertEquals(200, server.status("GET /api/service/talker", ""));
        assertEquals(404, server.status("GET /api/service/nix", ""));
    }

    @Test
    public void allOtherMethodsAreRefused() throws Exception {
        for (String method : new String[] {"PUT", "DELETE", "HEAD", "TRACE", "OPTIONS", "PATCH", "CONNECT", "BREW",
            "post", "Get"}) {
            for (String path : new String[] {TICK, "/api/service", "/", "/webjars/jquery/jquery.min.js",
                "/api/messages"}) {
                assertEquals(method + " " + path, 405, server.status(method + " " + path, "[]", JSON));
            }
        }
        assertEquals(405, server.status("POST /", "[]", JSON));
        assertEquals(405, server.status("POST /api/messages", "[]", JSON));
    }

    @Test
    public void webSocketsAreForPagesOfThisServer() throws Exception {
        try (Socket page = server.webSocket()) {
            assertTrue(Server.nextText(page.getInputStream()).startsWith("{\"services\":"));
        }
        assertNull(server.webSocket("/api/messages"));
        assertNull(server.webSocket("/api/messages", "Origin: http://evil.example"));
        assertNull(server.webSocket("/api/messages", "Origin: null"));
        assertNull(server.webSocket("/api/messages", "Origin: " + own(), "Sec-Fetch-Site: cross-site"));
    }

    @Test
    public void withoutAConfiguredTokenNoneIsRequired() {
        assertTrue(Token.current().fits(""));
        assertTrue(Token.current().fits("anything"));
        Token token = Token.require();
        assertFalse(token.fits(""));
        assertNotNull(token.text());
        assertTrue(token.fits(token.text()));
    }
}
