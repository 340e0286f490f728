// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.SEAR.FreePort;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Addresses and names of the server; it is open to other computers only with a token. */
public class AddressTest {
    private static final int PORT = 8901;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @After
    public void dismiss() {
        Address.dismiss();
        Token.dismiss();
    }

    private static InetAddress number(String text) throws IOException {
        return InetAddress.getByName(text);
    }

    @Test
    public void loopbackHasItsOwnNamesOnly() throws Exception {
        Address.Names names = Address.current().names(PORT);
        InetAddress reached = number("127.0.0.1");
        for (String name : List.of("localhost:8901", "127.0.0.1:8901", "[::1]:8901")) {
            assertTrue(name, names.has(name, reached));
        }
        String own = InetAddress.getLocalHost().getHostName();
        for (String name : List.of("localhost", "localhost:8902", "evil.example:8901", "", ":8901", own + ":8901",
            "192.168.1.5:8901", "localhost.:8901", "127.0.0.1:8901:8901", "[::1]evil:8901")) {
            assertFalse(name, names.has(name, reached));
        }
        assertEquals("http://localhost:8901", Address.current().url(PORT));
    }

    @Test
    public void openToOthersItHasTheNumbersThatItIsReachedBy() throws Exception {
        Address open = Address.listen("0.0.0.0", null);
        assertFalse(open.isLoopback());
        Address.Names names = open.names(PORT);
        InetAddress reached = number("192.168.1.5");
        for (String name : List.of("192.168.1.5:8901", InetAddress.getLocalHost().getHostName() + ":8901",
            "localhost:8901")) {
            assertTrue(name, names.has(name, reached));
        }
        assertTrue(names.has("[fe80::1]:8901", number("fe80::1")));
        for (String name : List.of("192.168.1.6:8901", "192.168.1.5", "evil.example:8901",
            "1.168.1.5.evil.example:8901", "[evil]:8901")) {
            assertFalse(name, names.has(name, reached));
        }
        assertTrue(open.url(PORT), open.url(PORT).matches("http://[^/]+:8901") && !open.url(PORT).contains("0.0.0.0"));
    }

    @Test
    public void aUrlIsAnotherName() throws Exception {
        Address.Names names = Address.listen(null, "https://Ada.School.example").names(PORT);
        InetAddress reached = number("127.0.0.1");
        assertTrue(names.has("ada.school.example", reached));
        assertFalse(names.has("ada.school.example:8901", reached));
        assertEquals("https://ada.school.example", names.origin("ada.school.example"));
        assertTrue(names.isSecure("ada.school.example"));
        assertEquals("http://localhost:8901", names.origin("localhost:8901"));
        assertFalse(names.isSecure("localhost:8901"));
        Address ported = Address.listen("0.0.0.0", "http://teacher:{port}/");
        assertEquals("http://teacher:8901", ported.url(PORT));
        assertTrue(ported.names(PORT).has("teacher:8901", reached));
        for (String wrong : List.of("teacher", "ftp://teacher", "http://teacher/path", "http://me@teacher",
            "http://teacher?x", "http://",
            "http://a b")) {
            assertThrows(wrong, IllegalArgumentException.class, () -> Address.listen(null, wrong));
        }
        assertThrows(IllegalArgumentException.class, () -> Address.listen("no such host.", null));
    }

    @Test
    public void listeningToOthersRequiresAToken() throws Exception {
        Address.listen("0.0.0.0", null);
        int port = FreePort.find();
        IOException refused = assertThrows(IOException.class, () -> new WebServer(port, List.of(), new Hub("hub")));
        assertEquals("other computers could reach this server without a token: the server does not start",
            refused.getMessage());
        new ServerSocket(port).close();
        Token.require();
        new WebServer(port, List.of(), new Hub("hub")).stop();
        Address.listen("192.0.2.1", null);
        IOException foreign = assertThrows(IOException.class, () -> new WebServer(port, List.of(), new Hub("hub")));
        assertTrue(foreign.getMessage(), foreign.getMessage().contains("can't listen at "));
    }

    @Test
    public void aTokenOfAFileIsLongAndPrivate() throws Exception {
        Path file = folder.getRoot().toPath().resolve("token");
        for (String wrong : List.of("", "fifteen-letters", "with a space in it", "sixteen-letters-\u00e4",
            "x".repeat(201))) {
            Token.writePrivate(file, wrong + "\n");
            assertThrows(wrong, IllegalArgumentException.class, () -> Token.require(file));
        }
        Token.writePrivate(file, "sixteen-letters-\n");
        assertTrue(Token.require(file).fits("sixteen-letters-"));
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r-----"));
        assertTrue(assertThrows(IOException.class, () -> Token.require(file)).getMessage().contains("chmod 600"));
    }

    @Test
    public void onlyALongTokenMakesCookiesThatOutliveTheProgram() throws Exception {
        Path file = folder.getRoot().toPath().resolve("token");
        Token.writePrivate(file, "short-but-legal-1");
        assertFalse(Token.require(file).cookie("here").equals(Token.require(file).cookie("here")));
        Token.writePrivate(file, Token.make());
        assertEquals(Token.require(file).cookie("here"), Token.require(file).cookie("here"));
    }

    @Test
    public void wrongOnesAreCountedForAMinuteEachAddressByItself() throws Exception {
        long[] now = {Long.MAX_VALUE - 5};
        TokenAttempts attempts = new TokenAttempts(() -> now[0]);
        for (int i = 1; i <= TokenAttempts.MOST; i++) {
            assertFalse(attempts.isOver(number("10.0.0.1")));
            assertEquals(i == TokenAttempts.MOST, attempts.count(number("10.0.0.1")));
            attempts.count(number("2001:db8::" + i));
        }
        assertTrue(attempts.isOver(number("10.0.0.1")));
        assertTrue("one house", attempts.isOver(number("2001:db8::ffff")));
        assertFalse(attempts.isOver(number("2001:db8:0:1::1")));
        assertFalse(attempts.isOver(number("10.0.0.2")));
        now[0] += TokenAttempts.WINDOW_SECONDS * 1_000_000_000L;
        assertFalse(attempts.isOver(number("10.0.0.1")));
    }
}
