// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.Handlers;
import io.undertow.UndertowOptions;
import io.undertow.server.DefaultByteBufferPool;
import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.server.handlers.PathHandler;
import io.undertow.server.handlers.resource.ClassPathResourceManager;
import io.undertow.server.handlers.resource.ResourceHandler;
import io.undertow.server.handlers.resource.ResourceManager;
import io.undertow.server.protocol.http.HttpOpenListener;
import io.undertow.util.Headers;
import io.undertow.util.StatusCodes;
import java.io.IOException;
import java.io.InputStream;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Properties;
import java.util.concurrent.TimeUnit;
import org.xnio.ChannelListeners;
import org.xnio.IoUtils;
import org.xnio.OptionMap;
import org.xnio.Options;
import org.xnio.StreamConnection;
import org.xnio.Xnio;
import org.xnio.XnioWorker;
import org.xnio.channels.AcceptingChannel;

/**
 * Serves pages, panels and calls to browsers on this computer; others need what {@link Address} and {@link Token} say.
 * Any thread.
 */
public final class WebServer {
    private static final String API = "/api";
    /** Folder of pages on the class path; contains no classes. */
    private static final String PAGES = "org/myrobotlab/embedded/pages";
    private static final String WEB_JARS = "META-INF/resources/webjars/";
    private static final String WEB_JAR_POM = "META-INF/maven/org.webjars/";
    private static final List<String> LIBRARIES = List.of("angularjs", "bootstrap", "jquery");
    /** Two, so that a blocked one does not stop the server. */
    private static final int IO_THREADS = 2;
    private static final int WORKERS = 8;
    /** Limit of open connections when all have a request; further ones wait. */
    private static final int MAX_CONNECTIONS = 2 * Connections.MOST;
    private static final int BUFFER = 1 << 14;
    /** Limit of connections that wait to be accepted. */
    private static final int BACKLOG = 1000;
    private static final int HEADERS_MILLIS = 30_000;
    /** Most bytes of a request's head. Connections without a token hold them while the head arrives. */
    private static final int HEAD = 1 << 14;
    private static final int IDLE_MILLIS = 60_000;
    private static final int STOP_SECONDS = 5;

    private final PageCalls calls;
    private final XnioWorker worker;
    private final HttpOpenListener http;
    private final AcceptingChannel<StreamConnection> server;
    private final int port;

    /**
     * @param folders folders on disk with panels; the first that has a file wins
     * @throws IOException if the port is taken, the address is not one of this computer, or other computers could
     *     connect without a token
     */
    public WebServer(int port, List<String> folders, Hub hub) throws IOException {
        this.port = port;
        HttpHandler files = classPath("resource", classPath("resource/WebGui/app", pages()));
        List<String> lastFirst = new ArrayList<>(folders);
        Collections.reverse(lastFirst);
        for (String folder : lastFirst) {
            files = new DiskHandler(folder, files);
        }
        calls = new PageCalls("web server " + port);
        Address address = Address.current();
        if (!address.isLoopback() && !Token.current().isAskedFor()) {
            throw new IOException("other computers could reach this server without a token: the server does not start");
        }
        Address.Names names = address.names(port);
        PathHandler paths = Handlers.path(Guard.reading(fresh(files)))
            .addPrefixPath(API + "/service", CallGuard.calls(new RestHandler(calls))).addExactPath(API + "/messages",
                CallGuard.sockets(Handlers.websocket((exchange, channel) -> hub.connect(channel, calls))));
        for (String name : LIBRARIES) {
            paths.addPrefixPath("/webjars/" + name, Guard.reading(library(name)));
        }
        worker = Xnio.getInstance(HttpOpenListener.class.getClassLoader())
            .createWorker(OptionMap.builder().set(Options.WORKER_IO_THREADS, IO_THREADS)
            .set(Options.WORKER_TASK_CORE_THREADS, WORKERS).set(Options.WORKER_TASK_MAX_THREADS, WORKERS)
            .set(Options.TCP_NODELAY, true).set(Options.WORKER_NAME, "web server " + port).getMap());
        http = new HttpOpenListener(new DefaultByteBufferPool(true, BUFFER), OptionMap.builder()
            // RequestBody has its own limit
            .set(UndertowOptions.BUFFER_PIPELINED_DATA, true).set(UndertowOptions.MAX_ENTITY_SIZE, -1L)
            .set(UndertowOptions.MAX_HEADER_SIZE, HEAD)
            .set(UndertowOptions.REQUEST_PARSE_TIMEOUT, HEADERS_MILLIS)
                .set(UndertowOptions.NO_REQUEST_TIMEOUT, IDLE_MILLIS).getMap());
        Connections connections = new Connections(http);
        http.setRootHandler(connections.watching(new Guard(new Login(paths, Token.current(), names), names)));
        server = listen(connections, address.socket(port));
        server.resumeAccepts();
    }

    /** Serves a library of the pages in the version on the class path. */
    private static ResourceHandler library(String name) throws IOException {
        Properties about = new Properties();
        try (InputStream in = WebServer.class.getClassLoader()
            .getResourceAsStream(WEB_JAR_POM + name + "/pom.properties")) {
            if (in == null) {
                throw new IOException("the library " + name + " (org.webjars) is not on the class path");
            }
            about.load(in);
        }
        String folder = WEB_JARS + name + "/" + about.getProperty("version");
        return new ResourceHandler(new ClassPathResourceManager(WebServer.class.getClassLoader(), folder));
    }

    /** Serves panels of plug-ins from the class path, for lack of their resource folder. */
    private static HttpHandler classPath(String folder, HttpHandler next) {
        HttpHandler files = new ResourceHandler(
            new ClassPathResourceManager(WebServer.class.getClassLoader(), folder), next);
        return exchange -> (exchange.getRelativePath().endsWith("/") ? next : files).handleRequest(exchange);
    }

    private static ResourceHandler pages() {
        ResourceManager pages = new ClassPathResourceManager(WebServer.class.getClassLoader(), PAGES);
        return new ResourceHandler(pages, WebServer::missing).setWelcomeFiles("index.html");
    }

    /** Answers a missing panel of a service with an empty page, as MyRobotLab does. */
    private static void missing(HttpServerExchange exchange) {
        exchange.setStatusCode(exchange.getRelativePath().startsWith("/service/") ? StatusCodes.OK
            : StatusCodes.NOT_FOUND);
        exchange.endExchange();
    }

    /** Disables caching: panels may change on disk at any time. */
    private static HttpHandler fresh(HttpHandler next) {
        return exchange -> {
            exchange.getResponseHeaders().put(Headers.CACHE_CONTROL, "no-cache");
            next.handleRequest(exchange);
        };
    }

    private AcceptingChannel<StreamConnection> listen(Connections connections, InetSocketAddress address)
        throws IOException {
        try {
            return worker.createStreamConnectionServer(address,
                ChannelListeners.openListenerAdapter(connections), OptionMap.builder().set(Options.TCP_NODELAY, true)
                    .set(Options.REUSE_ADDRESSES, true).set(Options.BACKLOG, BACKLOG)
                    .set(Options.CONNECTION_HIGH_WATER, MAX_CONNECTIONS)
                    .set(Options.CONNECTION_LOW_WATER, MAX_CONNECTIONS).getMap());
        } catch (BindException e) {
            worker.shutdownNow();
            boolean isTaken = String.valueOf(e.getMessage()).contains("in use");
            throw new IOException(isTaken ? "port " + port + " is in use by another program: choose another one"
                : "can't listen at " + address + ": " + e.getMessage(), e);
        } catch (IOException e) {
            worker.shutdownNow();
            throw e;
        }
    }

    /** Closes all connections and ends all threads; the thread of a page's call of this method ends after that call. */
    public void stop() {
        IoUtils.safeClose(server);
        http.closeConnections();
        calls.stop();
        worker.shutdownNow();
        try {
            worker.awaitTermination(STOP_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
