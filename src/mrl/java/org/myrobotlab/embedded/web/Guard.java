// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.HeaderValues;
import io.undertow.util.Headers;
import io.undertow.util.HttpString;
import io.undertow.util.Methods;
import io.undertow.util.StatusCodes;

/**
 * Checks every request. Rejects requests that name this server otherwise (DNS rebinding), requests of other servers'
 * pages, and all methods except GET and POST.
 */
final class Guard implements HttpHandler {
    private static final HttpString CONTENT_TYPE_OPTIONS = new HttpString("X-Content-Type-Options");
    private static final HttpString FRAME_OPTIONS = new HttpString("X-Frame-Options");

    private final HttpHandler next;
    private final Address.Names names;

    Guard(HttpHandler next, Address.Names names) {
        this.next = next;
        this.names = names;
    }

    @Override
    public void handleRequest(HttpServerExchange exchange) throws Exception {
        HeaderValues host = exchange.getRequestHeaders().get(Headers.HOST);
        HeaderValues origin = exchange.getRequestHeaders().get(Headers.ORIGIN);
        exchange.getResponseHeaders().put(CONTENT_TYPE_OPTIONS, "nosniff").put(FRAME_OPTIONS, "DENY");
        if (host == null || host.size() != 1
            || !names.has(host.getFirst(), exchange.getDestinationAddress().getAddress())) {
            refuse(exchange, StatusCodes.FORBIDDEN, "host " + host + " is not this server: use " + names.one());
        } else if (origin != null && !(origin.size() == 1 && origin.getFirst().equals(names.origin(host.getFirst())))) {
            refuse(exchange, StatusCodes.FORBIDDEN, "pages of " + origin + " may not call this server");
        } else if (!is(exchange, Methods.GET) && !is(exchange, Methods.POST)) {
            refuseMethod(exchange, "GET, POST");
        } else {
            next.handleRequest(exchange);
        }
    }

    /** Returns whether a request has this method; {@code post} is not {@code POST}. */
    static boolean is(HttpServerExchange exchange, HttpString method) {
        return exchange.getRequestMethod().toString().equals(method.toString());
    }

    /** Passes only GET. */
    static HttpHandler reading(HttpHandler next) {
        return exchange -> {
            if (is(exchange, Methods.GET)) {
                next.handleRequest(exchange);
            } else {
                refuseMethod(exchange, "GET");
            }
        };
    }

    private static void refuseMethod(HttpServerExchange exchange, String legal) {
        exchange.getResponseHeaders().put(Headers.ALLOW, legal);
        refuse(exchange, StatusCodes.METHOD_NOT_ALLOWED, "method " + exchange.getRequestMethod()
            + " is not allowed here, legal: " + legal);
    }

    /** Answers with a status and a reason, and ends the request. */
    static void refuse(HttpServerExchange exchange, int status, String why) {
        exchange.setStatusCode(status);
        exchange.getResponseSender().send(why + "\n");
    }
}
