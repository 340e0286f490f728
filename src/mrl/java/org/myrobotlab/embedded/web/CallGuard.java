package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.HttpString;
import io.undertow.util.Methods;
import io.undertow.util.StatusCodes;
import java.util.Deque;

/**
 * Stands before everything that reaches services. A browser says where a request comes from: only this server's own pages get in, and only their
 * scripts; a link, a redirect, a form or an address that a user opens never does. A call is a POST with JSON, which no form can send. Programs that
 * are no browsers say nothing of the kind; where a {@link Token} is asked for they need it, as pages do.
 */
final class CallGuard implements HttpHandler {
    private static final HttpString FETCH_SITE = new HttpString("Sec-Fetch-Site");
    private static final HttpString FETCH_MODE = new HttpString("Sec-Fetch-Mode");
    private static final String OWN_SITE = "same-origin";
    private static final String NAVIGATION = "navigate";
    private static final String JSON = "application/json";
    private static final String BEARER = "Bearer ";
    private static final String TOKEN = "token";

    private final HttpHandler next;
    private final Token token;

    private CallGuard(HttpHandler next, Token token) {
        this.next = next;
        this.token = token;
    }

    /** For calls over HTTP. */
    static HttpHandler calls(HttpHandler next, Token token) {
        return new CallGuard(exchange -> {
            if (Guard.is(exchange, Methods.POST) && !isJson(exchange.getRequestHeaders().getFirst(Headers.CONTENT_TYPE))) {
                Guard.refuse(exchange, StatusCodes.UNSUPPORTED_MEDIA_TYPE,
                    "a call is a list of arguments as JSON, with the header Content-Type: " + JSON);
            } else {
                next.handleRequest(exchange);
            }
        }, token);
    }

    /** For web sockets, which nobody but a page of this server may open. */
    static HttpHandler sockets(HttpHandler next, Token token) {
        return new CallGuard(Guard.reading(exchange -> {
            if (exchange.getRequestHeaders().contains(Headers.ORIGIN)) {
                next.handleRequest(exchange);
            } else {
                Guard.refuse(exchange, StatusCodes.FORBIDDEN, "a web socket needs the header Origin, with this server's own address");
            }
        }), token);
    }

    private static boolean isJson(String type) {
        return type != null && type.split(";", 2)[0].trim().equalsIgnoreCase(JSON);
    }

    @Override
    public void handleRequest(HttpServerExchange exchange) throws Exception {
        String site = exchange.getRequestHeaders().getFirst(FETCH_SITE);
        String mode = exchange.getRequestHeaders().getFirst(FETCH_MODE);
        if (site != null && !site.equals(OWN_SITE)) {
            Guard.refuse(exchange, StatusCodes.FORBIDDEN, "only pages of this server and programs of this computer may call, this came from " + site);
        } else if (NAVIGATION.equals(mode)) {
            Guard.refuse(exchange, StatusCodes.FORBIDDEN, "services are called by scripts and programs, not by opening an address");
        } else if (!token.fits(given(exchange))) {
            exchange.getResponseHeaders().put(Headers.WWW_AUTHENTICATE, BEARER.trim());
            Guard.refuse(exchange, StatusCodes.UNAUTHORIZED, "this server asks for a token, which was printed when it started: "
                + "send it in the header Authorization: Bearer TOKEN");
        } else {
            next.handleRequest(exchange);
        }
    }

    /** What a script can't put into a header when it opens a web socket stands in the address. */
    private static String given(HttpServerExchange exchange) {
        String header = exchange.getRequestHeaders().getFirst(Headers.AUTHORIZATION);
        if (header != null) {
            return header.startsWith(BEARER) ? header.substring(BEARER.length()).trim() : "";
        }
        Deque<String> values = exchange.getQueryParameters().get(TOKEN);
        return values == null ? "" : values.getFirst();
    }
}
