// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.HttpString;
import io.undertow.util.Methods;
import io.undertow.util.StatusCodes;

/**
 * Protects everything that reaches services. Browsers say where a request comes from: only scripts of this server's own
 * pages may call; links, redirects, forms and opened addresses may not. A call is a POST with JSON, which no form can
 * send. Programs other than browsers don't send these headers. {@link Login} checks the {@link Token} before, if there
 * is one.
 */
final class CallGuard implements HttpHandler {
    private static final HttpString FETCH_SITE = new HttpString("Sec-Fetch-Site");
    private static final HttpString FETCH_MODE = new HttpString("Sec-Fetch-Mode");
    private static final String OWN_SITE = "same-origin";
    private static final String NAVIGATION = "navigate";
    private static final String JSON = "application/json";

    private final HttpHandler next;

    private CallGuard(HttpHandler next) {
        this.next = next;
    }

    /** Guards calls over HTTP. */
    static HttpHandler calls(HttpHandler next) {
        return new CallGuard(exchange -> {
            if (Guard.is(exchange, Methods.POST)
                && !isJson(exchange.getRequestHeaders().getFirst(Headers.CONTENT_TYPE))) {
                Guard.refuse(exchange, StatusCodes.UNSUPPORTED_MEDIA_TYPE,
                    "a call needs a JSON list of arguments and the header Content-Type: " + JSON);
            } else {
                next.handleRequest(exchange);
            }
        });
    }

    /** Guards web sockets, which only pages of this server may open. */
    static HttpHandler sockets(HttpHandler next) {
        return new CallGuard(Guard.reading(exchange -> {
            if (exchange.getRequestHeaders().contains(Headers.ORIGIN)) {
                next.handleRequest(exchange);
            } else {
                Guard.refuse(exchange, StatusCodes.FORBIDDEN, "a web socket needs the header Origin, with this "
                    + "server's own address");
            }
        }));
    }

    private static boolean isJson(String type) {
        return type != null && type.split(";", 2)[0].trim().equalsIgnoreCase(JSON);
    }

    @Override
    public void handleRequest(HttpServerExchange exchange) throws Exception {
        String site = exchange.getRequestHeaders().getFirst(FETCH_SITE);
        String mode = exchange.getRequestHeaders().getFirst(FETCH_MODE);
        if (site != null && !site.equals(OWN_SITE)) {
            Guard.refuse(exchange, StatusCodes.FORBIDDEN,
                "only pages of this server and programs of this computer may call; this call came from " + site);
        } else if (NAVIGATION.equals(mode)) {
            Guard.refuse(exchange, StatusCodes.FORBIDDEN, "call services from scripts and programs, not by "
                + "opening an address");
        } else {
            next.handleRequest(exchange);
        }
    }
}
