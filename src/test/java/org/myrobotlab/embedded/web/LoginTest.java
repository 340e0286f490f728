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
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.Rule;
import org.junit.Test;

/** The token becomes a cookie, and no request succeeds without either. */
public class LoginTest {
    private static final String JSON = "Content-Type: application/json";
    private static final String FORM = "Content-Type: application/x-www-form-urlencoded";
    private static final String HTML = "Accept: text/html,*/*";
    private static final String HERE = "127.0.0.1";
    private static final String THERE = "127.0.0.2";
    private static final Pattern COOKIE = Pattern.compile("Set-Cookie: ([^;\r]*)([^\r]*)");

    @Rule
    public final Server server = new Server(true);

    private String own() {
        return "http://localhost:" + server.port();
    }

    private static int status(String response) {
        return Integer.parseInt(response.split(" ")[1]);
    }

    private String link(String from, String token) throws IOException {
        return server.response(from, "GET /?token=" + token, "", HTML);
    }

    private String form(String from, String token) throws IOException {
        return server.response(from, "POST /login", "token=" + token, FORM, "Origin: " + own());
    }

    private static String cookie(String response) {
        Matcher cookie = COOKIE.matcher(response);
        assertTrue(response, cookie.find());
        return "Cookie: " + cookie.group(1);
    }

    @Test
    public void linkAndFormSetACookieForAllPaths() throws Exception {
        for (String entered : new String[] {link(HERE, server.token().text()), form(HERE, server.token().text())}) {
            assertEquals(entered, 200, status(entered));
            Matcher cookie = COOKIE.matcher(entered);
            assertTrue(entered, cookie.find());
            assertEquals("; Path=/; HttpOnly; SameSite=Strict", cookie.group(2));
            assertTrue(cookie.group(1), cookie.group(1).startsWith("sear-" + server.port() + "="));
            assertFalse("the token is nowhere in it", entered.contains(server.token().text()));
            assertTrue(entered, entered.contains("Referrer-Policy: no-referrer")
                && entered.contains("Cache-Control: no-store"));
        }
        String cookie = cookie(link(HERE, server.token().text()));
        assertEquals(200, server.status("GET /", "", cookie));
        assertEquals(200, server.status("GET /mrl.js", "", "Cookie: a=b; " + cookie.substring("Cookie: ".length())
            + "; c=d"));
        assertEquals(200, server.status("POST /api/service/talker/tick", "[]", JSON, cookie, "Origin: " + own()));
        assertEquals("tick", server.talker().heard.take());
        try (Socket page = server.webSocket("/api/messages", "Origin: " + own(), cookie)) {
            assertNotNull(page);
        }
        assertTrue(server.response(HERE, "GET /", "", cookie).contains("Referrer-Policy: same-origin"));
    }

    @Test
    public void peopleGetTheLoginFormAndProgramsAnError() throws Exception {
        String asked = server.response(HERE, "GET /", "", HTML);
        assertEquals(401, status(asked));
        assertTrue(asked, asked.contains("<form method=\"post\" action=\"/login\"")
            && asked.contains("role=\"alert\"></p>"));
        assertTrue(asked, asked.contains("Content-Security-Policy: default-src 'none'"));
        assertTrue(server.response(HERE, "GET /api/service", "", HTML)
            .endsWith("send it in the header Authorization: Bearer TOKEN\n"));
        for (String wrong : new String[] {link(HERE, "wrong"), form(HERE, "wrong"), link(HERE, ""), form(HERE, "%"),
            form(HERE, "%ff%00")}) {
            assertEquals(401, status(wrong));
            assertTrue(wrong, wrong.contains("This is not the token of this server."));
            assertFalse(wrong, wrong.contains("Set-Cookie"));
        }
    }

    @Test
    public void withoutTheCookieNoPathLeadsIn() throws Exception {
        for (String path : new String[] {"/", "/index.html", "/mrl.js", "/webjars/jquery/jquery.min.js",
            "/service/views/SEARGui.html", "//", "/./",
            "/%2e/", "/login", "/login/../", "/login/", "/login;x", "/LOGIN", "/login%00", "/login/../api/service",
            "/%6cogin", "/api",
            "/api/service", "//api//service", "/%61pi/service", "/api/service;token=" + server.token().text(),
            "/resource/..%2f..%2fetc/passwd",
            "/../../etc/passwd", own() + "/", own() + "/api/service", "/?Token=" + server.token().text(),
            "/?token=a&token=" + server.token().text(),
            "/?x=token=" + server.token().text(), "/index.html?token=" + server.token().text(), "/api/service?token="
                + server.token().text()}) {
            assertNotEquals(path, 200, server.status("GET " + path, "", HTML));
        }
        assertEquals(401, server.status("POST /api/service/talker/tick?token=" + server.token().text(), "[]", JSON));
        assertEquals(401, server.status("POST /api/service/talker/tick", "token=" + server.token().text(), FORM));
        assertEquals(401, server.status("POST /?token=" + server.token().text(), "", FORM));
        assertEquals(0, server.talker().heard.size());
    }

    @Test
    public void otherCookiesAreNone() throws Exception {
        String name = "sear-" + server.port();
        String right = cookie(link(HERE, server.token().text()));
        String value = right.substring(right.indexOf('=') + 1);
        for (String wrong : new String[] {name + "=" + server.token().text(), name + "=", name, "sear=" + value,
            "=" + value, "sear-" + (server.port() + 1) + "=" + value, name + "=" + server.token()
            .cookie("sear-" + (server.port() + 1) + " " + HERE),
            name + "=" + value + "x", name + "=\"" + value + "\""}) {
            assertEquals(wrong, 401, server.status("GET /", "", "Cookie: " + wrong));
            assertNull(server.webSocket("/api/messages", "Origin: " + own(), "Cookie: " + wrong));
        }
        String tossed = "Cookie: " + name + "=junk; " + name + "=" + value;
        assertEquals("what another port's page has put before it", 200, server.status("GET /", "", tossed));
        assertEquals("stolen, from another computer", 401, status(server.response(THERE, "GET /", "", right)));
        assertEquals(200, status(server.response(HERE, "GET /", "", right)));
    }

    @Test
    public void aCookieDoesNotAdmitOtherPages() throws Exception {
        String cookie = cookie(link(HERE, server.token().text()));
        String neighbour = "Origin: http://localhost:" + (server.port() + 1);
        assertEquals(403, server.status("POST /api/service/talker/tick", "[]", JSON, cookie, neighbour));
        assertEquals(403, server.status("GET /", "", cookie, neighbour));
        assertEquals("what a form of a neighbour's page sends", 415,
            server.status("POST /api/service/talker/tick", "[]", FORM, cookie));
        assertNull(server.webSocket("/api/messages", neighbour, cookie));
        assertEquals(403, server.status("POST /login", "token=" + server.token().text(), FORM, neighbour));
        assertEquals(0, server.talker().heard.size());
    }

    @Test
    public void onlyAClientWithTooManyAttemptsWaits() throws Exception {
        String cookie = cookie(link(THERE, server.token().text()));
        for (int i = 0; i < TokenAttempts.MOST; i++) {
            assertEquals(401, status(i % 2 == 0 ? form(THERE, "wrong") : link(THERE, "wrong")));
        }
        assertTrue(form(THERE, "wrong").contains("Too many wrong tokens have come from your address."));
        assertEquals(429, status(server.response(THERE, "GET /api/service", "", "Authorization: Bearer wrong")));
        assertEquals("who is in stays in", 200, status(server.response(THERE, "GET /", "", cookie)));
        assertEquals("a token that nobody can guess is always right", 200, status(link(THERE, server.token().text())));
        assertEquals(401, status(form(HERE, "wrong")));
        assertEquals(200, status(form(HERE, server.token().text())));
    }

    @Test
    public void theFormAcceptsOnlyPossibleTokens() throws Exception {
        assertEquals(413, status(form(HERE, "x".repeat(2000))));
        String chunked = server.head("POST /login", FORM, "Transfer-Encoding: chunked") + "\r\n6\r\ntoken=\r\n";
        try (Socket socket = server.connect()) {
            Server.send(socket, chunked);
            byte[] begin = socket.getInputStream().readNBytes("HTTP/1.1 413".length());
            assertEquals("HTTP/1.1 413", new String(begin, java.nio.charset.StandardCharsets.US_ASCII));
        }
        server.talker().heard.clear();
        assertEquals(200, status(form(HERE, server.token().text())));
    }
}
