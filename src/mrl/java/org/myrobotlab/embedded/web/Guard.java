package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.HttpString;
import io.undertow.util.StatusCodes;
import java.util.Set;

/**
 * Lets only pages of this very server in: whoever calls it by another name (DNS rebinding) or from a page of another server is refused, since every
 * method of every service can be called here.
 */
final class Guard implements HttpHandler {
    private static final HttpString FETCH_SITE = new HttpString("Sec-Fetch-Site");
    private static final Set<String> OWN_SITES = Set.of("same-origin", "none");

    private final HttpHandler next;
    private final Set<String> hosts;

    Guard(HttpHandler next, int port) {
        this.next = next;
        this.hosts = Set.of("localhost:" + port, "127.0.0.1:" + port, "[::1]:" + port);
    }

    @Override
    public void handleRequest(HttpServerExchange exchange) throws Exception {
        String host = exchange.getRequestHeaders().getFirst(Headers.HOST);
        String origin = exchange.getRequestHeaders().getFirst(Headers.ORIGIN);
        String site = exchange.getRequestHeaders().getFirst(FETCH_SITE);
        if (host == null || !hosts.contains(host)) {
            refuse(exchange, "host " + host + " is refused: call this server localhost");
        } else if (origin != null && !(origin.startsWith("http://") && hosts.contains(origin.substring("http://".length())))) {
            refuse(exchange, "pages of " + origin + " are refused");
        } else if (site != null && !OWN_SITES.contains(site) && isCall(exchange)) {
            refuse(exchange, "pages of other servers are refused");
        } else {
            exchange.getResponseHeaders().put(new HttpString("X-Content-Type-Options"), "nosniff").put(new HttpString("X-Frame-Options"), "DENY");
            next.handleRequest(exchange);
        }
    }

    private static boolean isCall(HttpServerExchange exchange) {
        return exchange.getRequestPath().startsWith(WebServer.API);
    }

    private static void refuse(HttpServerExchange exchange, String why) {
        exchange.setStatusCode(StatusCodes.FORBIDDEN);
        exchange.getResponseSender().send(why + "\n");
    }
}
