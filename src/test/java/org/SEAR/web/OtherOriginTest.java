// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.AfterClass;
import org.junit.BeforeClass;
import org.junit.Test;

/** A browser on this computer opens pages of another server, which try every way to run Python here. */
public class OtherOriginTest {
    private static final String WRITES = "open('%s','w').close()";

    private static MyRobotLab robotLab;
    private static Browser browser;
    private static HttpServer evil;
    /** Reports of the other server's pages. */
    private static final Set<String> REPORTS = ConcurrentHashMap.newKeySet();

    @BeforeClass
    public static void start() throws Exception {
        robotLab = new MyRobotLab("pass");
        browser = new Browser(800, 600);
        evil = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        evil.createContext("/", OtherOriginTest::answer);
        evil.start();
    }

    @AfterClass
    public static void stop() {
        evil.stop(0);
        browser.close();
        robotLab.close();
    }

    private static void answer(HttpExchange exchange) throws IOException {
        String path = exchange.getRequestURI().getPath();
        byte[] page = new byte[0];
        int status = 200;
        if (path.startsWith("/redirect/")) {
            status = 302;
            exchange.getResponseHeaders().set("Location", call(path.substring("/redirect/".length())));
        } else if (path.startsWith("/report/")) {
            REPORTS.add(path.substring("/report/".length()));
        } else {
            exchange.getResponseHeaders().set("Content-Type", "text/html; charset=utf-8");
            page = page(path.substring(1)).getBytes(StandardCharsets.UTF_8);
        }
        exchange.sendResponseHeaders(status, page.length == 0 ? -1 : page.length);
        exchange.getResponseBody().write(page);
        exchange.close();
    }

    private static String code(String file) {
        return String.format(WRITES, file);
    }

    private static String api() {
        return robotLab.url() + "api/service/python/exec";
    }

    /** Returns a call as an address, for a link. */
    private static String call(String file) {
        return api() + "/" + code(file).replace("'", "%22").replace(",", "%2C");
    }

    private static String json(String file) {
        return "[\"" + code(file) + "\"]";
    }

    /** Returns a page by name; each page attempts a call immediately or has something to click. */
    private static String page(String name) {
        String done = ".then(function(a) { return fetch('/report/" + name + "') }, function() { return fetch('/report/"
            + name + "') })";
        String ended = "fetch('/report/" + name + "')";
        Map<String, String> pages = Map.of(
            "link", "<a id='go' href='" + call("link") + "'>go</a>",
            "image", "<img src='" + call("image") + "' onerror=\"" + ended + "\"><script src='" + call("script")
            + "'></script>", "frame", "<iframe src='" + call("frame") + "' onload=\"" + ended + "\"></iframe>",
            "form", "<form id='form' method='post' enctype='text/plain' action='" + api() + "'><input name='"
            + json("form").replace("\"", "&quot;")
                .replace("]", ", &quot;") + "' value='&quot;]'></form><script>document.forms[0].submit()</script>",
            "fetch", "<script>fetch('" + api() + "', {method: 'POST', headers: {'Content-Type': "
                + "'application/json'}, body: '" + json("fetch").replace("'", "\\'") + "'})" + done + "</script>",
            "simplefetch", "<script>fetch('" + api() + "', {method: 'POST', mode: 'no-cors', body: '"
                + json("simplefetch").replace("'", "\\'") + "'})" + done + "</script>",
            "getfetch", "<script>fetch('" + call("getfetch") + "', {mode: 'no-cors'})" + done + "</script>",
            "put", "<script>fetch('" + api() + "', {method: 'PUT', body: '" + json("put").replace("'", "\\'") + "'})"
            + done + "</script>", "socket", "<script>var s = new WebSocket('" + api().replace("http:", "ws:")
            .replace("service/python/exec", "messages") + "');"
                + "s.onopen = function() { s.send(JSON.stringify({name: 'python', method: 'exec', data: "
                + json("socket") + "})) };s.onclose = s.onerror = function() { " + ended + " }</script>");
        return "<!DOCTYPE html><title>" + name + "</title>" + pages.getOrDefault(name, "");
    }

    private String evil(String path) {
        return "http://localhost:" + evil.getAddress().getPort() + "/" + path;
    }

    /** Runs all pages and waits each time until the browser has its answer. */
    private void tryEverything() {
        REPORTS.clear();
        for (String name : List.of("image", "frame", "fetch", "simplefetch", "getfetch", "put", "socket")) {
            browser.driver().get(evil(name));
            browser.until("the end of " + name, () -> REPORTS.contains(name));
        }
        browser.driver().get(evil("redirect/redirect"));
        browser.driver().get(call("address"));
        browser.driver().get(evil("link"));
        browser.click("#go");
        browser.until("the link", () -> !browser.driver().getCurrentUrl().endsWith("/link"));
        browser.driver().get(evil("form"));
        browser.until("the form", () -> !browser.driver().getCurrentUrl().endsWith("/form"));
        for (String file : new String[] {"image", "script", "frame", "fetch", "simplefetch", "getfetch", "put",
            "socket", "redirect", "address", "link", "form"}) {
            assertFalse(file + " ran code", Files.exists(robotLab.file(file)));
        }
    }

    @Test
    public void nothingRunsBeforeAndAfterARealPageHasBeenOpened() {
        tryEverything();
        browser.driver().get(robotLab.url());
        browser.see("mrl-panel[name='python'] > *");
        tryEverything();
        assertEquals("programs still call", "true", robotLab.call("python", "exec", code("program")).asText());
        assertTrue(Files.exists(robotLab.file("program")));
    }
}
