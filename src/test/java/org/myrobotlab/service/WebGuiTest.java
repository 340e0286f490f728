// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.SEAR.FreePort;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.framework.Talker;

/** The web server of the embedded MyRobotLab: files, calls, messages, and rejected clients. */
@Category(Slow.class)
public class WebGuiTest {
    private static final int MANY = 1000;
    /** Fewer messages than the queue of a slow page holds. */
    private static final int BATCH = 50;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private final HttpClient client = HttpClient.newHttpClient();
    private final BlockingQueue<Map<?, ?>> messages = new LinkedBlockingQueue<>();
    private WebGui webGui;
    private Talker talker;
    private int port;

    @Before
    public void start() throws IOException {
        port = FreePort.find();
        webGui = (WebGui) Runtime.create("webgui", "WebGui");
        webGui.setPort(port);
        webGui.getConfig().resources = List.of(folder.newFolder("pages").toString());
        webGui.startService();
        talker = (Talker) Runtime.start("talker", Talker.class.getName());
    }

    @After
    public void release() {
        Runtime.releaseAll();
    }

    private HttpResponse<String> get(String path) throws IOException, InterruptedException {
        return client.send(HttpRequest.newBuilder(URI.create("http://localhost:" + port + path)).build(),
            HttpResponse.BodyHandlers.ofString());
    }

    private HttpResponse<String> post(String path, String body) throws IOException, InterruptedException {
        URI uri = URI.create("http://localhost:" + port + path);
        return client.send(HttpRequest.newBuilder(uri).header("Content-Type", "application/json")
            .POST(HttpRequest.BodyPublishers.ofString(body)).build(), HttpResponse.BodyHandlers.ofString());
    }

    private WebSocket open() {
        String host = "localhost:" + port;
        return client.newWebSocketBuilder().header("Origin", "http://" + host)
            .buildAsync(URI.create("ws://" + host + "/api/messages"),
                new WebSocket.Listener() {
            private final StringBuilder text = new StringBuilder();

            @Override
            public CompletionStage<?> onText(WebSocket socket, CharSequence data, boolean last) {
                text.append(data);
                if (last) {
                    messages.add(CodecUtils.fromJson(text.toString(), Map.class));
                    text.setLength(0);
                }
                socket.request(1);
                return null;
            }
        }).join();
    }

    /** Returns the next message with this key. */
    private Map<?, ?> next(String key) throws InterruptedException {
        while (true) {
            Map<?, ?> message = messages.poll(60, TimeUnit.SECONDS);
            assertTrue("no message with " + key + " came for 60 s", message != null);
            if (message.containsKey(key)) {
                return message;
            }
        }
    }

    @Test
    public void pagesLibrariesAndPanelsAreServed() throws Exception {
        assertTrue(get("/").body().contains("ng-app=\"mrlapp\""));
        assertTrue(get("/webjars/angularjs/angular.min.js").body().startsWith("/*\n AngularJS v1.5.3"));
        assertEquals(200, get("/webjars/bootstrap/css/bootstrap.min.css").statusCode());
        assertEquals(200, get("/webjars/jquery/jquery.min.js").statusCode());
        assertTrue(get("/service/js/PythonGui.js").body().contains("PythonGuiCtrl"));
        assertTrue(get("/service/js/SEARGui.js").body().contains("SEARGuiCtrl"));
        assertEquals(404, get("/nix.html").statusCode());
    }

    @Test
    public void aMissingPanelIsEmptyAndAFileOnTheDiskTakesPrecedence() throws Exception {
        assertEquals(200, get("/service/js/NixGui.js").statusCode());
        assertEquals("", get("/service/js/NixGui.js").body());
        Path panel = folder.getRoot().toPath().resolve("pages/service/js/PythonGui.js");
        Files.createDirectories(panel.getParent());
        Files.writeString(panel, "mine");
        assertEquals("mine", get("/service/js/PythonGui.js").body());
        assertTrue(get("/service/js/PythonGui.js").headers().firstValue("content-type").orElse("")
            .endsWith("/javascript"));
        Files.writeString(folder.getRoot().toPath().resolve("secret"), "secret");
        assertEquals(404, get("/%2e%2e/secret").statusCode());
    }

    @Test
    public void callsUsePostAndReadingsGet() throws Exception {
        assertEquals("1.5\n", post("/api/service/talker/half", "[3]").body());
        assertEquals("true\n", get("/api/service/talker/isRunning").body());
        assertEquals(405, get("/api/service/talker/half/3").statusCode());
        assertEquals("call half by POST, with a JSON list of arguments\n", get("/api/service/talker/half/3").body());
        assertEquals("[4,5]\n", post("/api/service/talker/publishArray", "[[4, 5]]").body());
        assertTrue(get("/api/service").body().contains("\"talker@embedded\""));
        assertTrue(get("/api/service/talker").body().contains("\"simpleName\":\"Talker\""));
        assertEquals("null\n", post("/api/service/talker/tick", "").body());
        assertEquals("tick", talker.heard.take());
    }

    @Test
    public void anyNameOfASensorIsReadByGet() throws Exception {
        String[][] names = {{"rover%2Fping", "rover/ping"}, {"1%20eye", "1 eye"}, {"1.50", "1.50"}, {"null", "null"},
            {"%22quoted%22", "quoted"}};
        for (String[] name : names) {
            assertEquals("\"of " + name[1] + "\"\n", get("/api/service/talker/getReading/" + name[0]).body());
        }
    }

    @Test
    public void wrongCallsAreReported() throws Exception {
        assertEquals("\"there is no service nix\"\n", get("/api/service/nix").body());
        assertEquals(404, get("/api/service/nix").statusCode());
        assertEquals("\"Talker has no method half for the arguments [1,2]\"\n",
            post("/api/service/talker/half", "[1, 2]").body());
        assertTrue(post("/api/service/talker/half", "[1").body().startsWith("\"not JSON for List"));
        assertTrue(post("/api/service/talker/half", "[1] [2]").body().startsWith("\"not JSON for List"));
        assertEquals("what JavaScript makes of NaN is no 0", "\"Talker has no method half for the arguments [null]: "
            + "argument 1 is null, legal: a value of type double\"\n",
                post("/api/service/talker/half", "[null]").body());
        assertEquals(500, post("/api/service/talker/fail", "[]").statusCode());
        assertEquals("\"talker.fail: no good\"\n", post("/api/service/talker/fail", "[]").body());
    }

    @Test
    public void pagesReceiveTheirSubscriptions() throws Exception {
        WebSocket page = open();
        assertTrue(next("services").get("services").toString().contains("name=talker"));
        page.sendText("{\"subscribe\":\"talker\",\"topic\":\"publishNumber\"}", true).join();
        page.sendText("{\"id\":1,\"name\":\"talker\",\"method\":\"half\",\"data\":[5]}", true).join();
        assertEquals(2.5, next("answer").get("answer"));
        page.sendText("{\"id\":2,\"name\":\"talker\",\"method\":\"whoCalls\"}", true).join();
        assertFalse("answers don't wait for the service's thread", "talker".equals(next("answer").get("answer")));
        page.sendText("{\"name\":\"talker\",\"method\":\"publishNumber\",\"data\":[7]}", true).join();
        assertEquals("{name=talker, method=onNumber, data=[7]}", next("method").toString());
        talker.invoke("publishNumber", 8);
        assertEquals(List.of(8), next("method").get("data"));
        page.sendText("{\"id\":3,\"name\":\"nix\",\"method\":\"go\"}", true).join();
        assertEquals("there is no service nix", next("error").get("error"));
        page.sendText("nonsense", true).join();
        assertTrue(next("error").get("error").toString().startsWith("not JSON for Map"));
        page.abort();
    }

    @Test
    public void messagesOfAPageKeepTheirOrder() throws Exception {
        WebSocket page = open();
        page.sendText("{\"subscribe\":\"talker\",\"topic\":\"publishNumber\"}", true).join();
        for (int round = 0; round < MANY; round += BATCH) {
            for (int i = 0; i < BATCH; i++) {
                page.sendText("{\"name\":\"talker\",\"method\":\"publishNumber\",\"data\":[" + (round + i) + "]}",
                    true).join();
            }
            for (int i = 0; i < BATCH; i++) {
                assertEquals(List.of(round + i), next("method").get("data"));
            }
        }
        page.abort();
    }

    @Test
    public void subscriptionsOutliveTheService() throws Exception {
        WebSocket page = open();
        next("services");
        page.sendText("{\"subscribe\":\"talker\",\"topic\":\"publishState\"}", true).join();
        page.sendText("{\"id\":1,\"name\":\"talker\",\"method\":\"half\",\"data\":[5]}", true).join();
        next("answer");
        Runtime.release("talker");
        while (next("services").get("services").toString().contains("name=talker")) {
            assertTrue(Runtime.getService("talker") == null);
        }
        talker = (Talker) Runtime.start("talker", Talker.class.getName());
        while (!next("services").get("services").toString().contains("name=talker")) {
            assertTrue(talker.isRunning());
        }
        talker.broadcastState();
        assertEquals("Talker", ((Map<?, ?>) ((List<?>) next("method").get("data")).get(0)).get("simpleName"));
        page.abort();
    }

    /** At the end of a simulation a page may still request the state of its ports. */
    @Test
    public void aJustReleasedServiceIsNoErrorOfThePage() throws Exception {
        WebSocket page = open();
        next("services");
        Runtime.release("talker");
        page.sendText("{\"name\":\"talker\",\"method\":\"broadcastState\"}", true).join();
        page.sendText("{\"name\":\"nix\",\"method\":\"broadcastState\"}", true).join();
        assertEquals("of the one that never was, not of the other", "there is no service nix", next("error")
            .get("error"));
        page.sendText("{\"id\":1,\"name\":\"talker\",\"method\":\"half\",\"data\":[5]}", true).join();
        assertEquals("who waits for an answer hears of it", "there is no service talker", next("error").get("error"));
        page.abort();
    }

    /** Waits until this number of the talker's topics have page listeners. */
    private void waitForTopics(int wanted) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        while (talker.getOutbox().getAttached("publishNumber").size() + talker.getOutbox().getAttached("publishState")
            .size() != wanted) {
            assertTrue("not " + wanted + " for 60 s: " + talker.getNotifyList(), System.nanoTime() < end);
            Thread.onSpinWait();
        }
    }

    @Test
    public void subscriptionsEndWithTheLastPage() throws Exception {
        WebSocket first = open();
        WebSocket second = open();
        for (WebSocket page : List.of(first, second)) {
            page.sendText("{\"subscribe\":\"talker\",\"topic\":\"publishNumber\"}", true).join();
            page.sendText("{\"subscribe\":\"talker\",\"topic\":\"publishState\"}", true).join();
        }
        waitForTopics(2);
        first.sendText("{\"unsubscribe\":\"talker\",\"topic\":\"publishNumber\"}", true).join();
        first.sendText("{\"id\":1,\"name\":\"talker\",\"method\":\"half\",\"data\":[5]}", true).join();
        next("answer");
        waitForTopics(2);
        second.sendText("{\"unsubscribe\":\"talker\",\"topic\":\"publishNumber\"}", true).join();
        waitForTopics(1);
        first.abort();
        second.sendClose(WebSocket.NORMAL_CLOSURE, "").join();
        waitForTopics(0);
    }

    @Test
    public void aPortInUseIsAnErrorAndReleasingFreesIt() throws Exception {
        WebGui second = (WebGui) Runtime.create("second", "WebGui");
        second.setPort(port);
        second.startService();
        assertFalse(second.isStarted());
        assertEquals("port " + port + " is in use by another program: choose another one", second.getLastError().key);
        webGui.stop();
        assertFalse(webGui.isStarted());
        second.restart();
        assertTrue(second.isStarted());
    }

    @Test
    public void releasingLeavesNoThread() {
        webGui.releaseService();
        Set<String> left = new HashSet<>();
        Thread.getAllStackTraces().keySet().stream().map(Thread::getName).filter(name -> name.startsWith("XNIO"))
            .forEach(left::add);
        assertEquals(Set.of(), left);
    }
}
