// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.HttpString;
import io.undertow.util.Methods;
import io.undertow.util.StatusCodes;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.Deque;
import java.util.List;
import org.myrobotlab.logging.LoggerFactory;
import org.slf4j.Logger;

/**
 * Checks the {@link Token}, if there is one, before every page, file, call and web socket. The token comes in a link,
 * {@code /?token=...}, from the form of the login page, or in a program's header {@code Authorization: Bearer ...}; not
 * otherwise. A browser gets a cookie in exchange. The cookie does not reveal the token, is named after the port, and is
 * valid only for the client address.
 */
final class Login implements HttpHandler {
    private static final Logger LOG = LoggerFactory.getLogger(Login.class);
    private static final HttpString REFERRER_POLICY = new HttpString("Referrer-Policy");
    private static final HttpString CONTENT_POLICY = new HttpString("Content-Security-Policy");
    private static final String PAGE_POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src "
        + "'unsafe-inline'; form-action 'self'; frame-ancestors 'none'; base-uri 'none'";
    private static final String BEARER = "Bearer ";
    private static final String TOKEN = "token";
    private static final String FORM = "/login";
    private static final String CALLS = "/api";
    private static final String HTML = "text/html";
    /** Limit of the submitted form, bytes. */
    private static final int LONGEST = 1000;
    private static final String WRONG = "This is not the token of this server.";
    private static final String TOO_MANY = "Too many wrong tokens have come from your address. Try again in a minute.";

    private final HttpHandler next;
    private final Token token;
    private final Address.Names names;
    private final TokenAttempts attempts = new TokenAttempts(System::nanoTime);

    Login(HttpHandler next, Token token, Address.Names names) {
        this.next = next;
        this.token = token;
        this.names = names;
    }

    @Override
    public void handleRequest(HttpServerExchange exchange) throws Exception {
        if (!token.isAskedFor()) {
            next.handleRequest(exchange);
            return;
        }
        exchange.getResponseHeaders().put(REFERRER_POLICY, "same-origin");
        String link = inLink(exchange);
        List<String> header = exchange.getRequestHeaders().get(Headers.AUTHORIZATION);
        if (exchange.getRequestPath().equals(FORM)) {
            form(exchange);
        } else if (link != null) {
            enter(exchange, judge(exchange, link));
        } else if (header != null) {
            String only = header.size() == 1 ? header.get(0) : "";
            int status = judge(exchange, only.startsWith(BEARER) ? only.substring(BEARER.length()).trim() : "");
            if (status == StatusCodes.OK) {
                next.handleRequest(exchange);
            } else {
                ask(exchange, status);
            }
        } else if (hasCookie(exchange)) {
            next.handleRequest(exchange);
        } else {
            ask(exchange, StatusCodes.UNAUTHORIZED);
        }
    }

    /** Returns the token of a link to the first page; null if there is none. */
    private static String inLink(HttpServerExchange exchange) {
        Deque<String> values = exchange.getQueryParameters().get(TOKEN);
        boolean isLink = values != null && Guard.is(exchange, Methods.GET) && exchange.getRequestPath().equals("/");
        return isLink ? values.size() == 1 ? values.getFirst() : "" : null;
    }

    private void form(HttpServerExchange exchange) {
        if (!Guard.is(exchange, Methods.POST)) {
            ask(exchange, hasCookie(exchange) ? StatusCodes.NOT_FOUND : StatusCodes.UNAUTHORIZED);
        } else if (exchange.getRequestContentLength() < 0 || exchange.getRequestContentLength() > LONGEST) {
            exchange.setPersistent(false);
            Guard.refuse(exchange, StatusCodes.REQUEST_ENTITY_TOO_LARGE, "this is not a token");
        } else {
            RequestBody.receive(exchange, (whole, body) -> enter(whole, judge(whole, field(body))));
        }
    }

    private static String field(String body) {
        try {
            return body.startsWith(TOKEN + "=") ? URLDecoder.decode(body.substring(TOKEN.length() + 1),
                StandardCharsets.UTF_8).trim() : "";
        } catch (IllegalArgumentException e) {
            return "";
        }
    }

    /** The right token always passes, except a short one after too many wrong attempts: that limits guessing. */
    private int judge(HttpServerExchange exchange, String given) {
        InetAddress from = exchange.getSourceAddress().getAddress();
        boolean isOver = attempts.isOver(from);
        if ((!isOver || token.isLong()) && token.fits(given)) {
            return StatusCodes.OK;
        }
        if (attempts.count(from)) {
            LOG.warn("{} wrong tokens from {}", TokenAttempts.MOST, from.getHostAddress());
        }
        return isOver ? StatusCodes.TOO_MANY_REQUESTS : StatusCodes.UNAUTHORIZED;
    }

    /** Returns the name of this port's cookie; browsers send the cookies of one host to all its ports. */
    private static String cookieName(String host) {
        int colon = host.lastIndexOf(':');
        return "sear" + (colon > host.lastIndexOf(']') ? "-" + host.substring(colon + 1) : "");
    }

    private String cookie(HttpServerExchange exchange) {
        String name = cookieName(host(exchange));
        return name + "=" + token.cookie(name + " " + exchange.getSourceAddress().getAddress().getHostAddress());
    }

    private static String host(HttpServerExchange exchange) {
        return exchange.getRequestHeaders().getFirst(Headers.HOST);
    }

    /** Accepts one right cookie among several of the same name, because pages of other ports may add some. */
    private boolean hasCookie(HttpServerExchange exchange) {
        List<String> headers = exchange.getRequestHeaders().get(Headers.COOKIE);
        if (headers == null) {
            return false;
        }
        String right = cookie(exchange);
        for (String header : headers) {
            for (String one : header.split(";")) {
                if (Token.isSame(right, one.trim())) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * Answers a link or the form. The page itself leads on: a strict cookie is not sent along a redirect from another
     * page's link.
     */
    private void enter(HttpServerExchange exchange, int status) {
        if (status == StatusCodes.OK) {
            exchange.getResponseHeaders().put(Headers.SET_COOKIE, cookie(exchange)
                + "; Path=/; HttpOnly; SameSite=Strict"
                + (names.isSecure(host(exchange)) ? "; Secure" : "")).put(REFERRER_POLICY, "no-referrer");
            send(exchange, status, "entered.html", "");
        } else {
            send(exchange, status, "login.html", status == StatusCodes.TOO_MANY_REQUESTS ? TOO_MANY : WRONG);
        }
    }

    /** Answers a request without token and cookie; users get the login page. */
    private static void ask(HttpServerExchange exchange, int status) {
        exchange.getResponseHeaders().put(Headers.WWW_AUTHENTICATE, BEARER.trim());
        String accepted = exchange.getRequestHeaders().getFirst(Headers.ACCEPT);
        if (status == StatusCodes.UNAUTHORIZED && Guard.is(exchange, Methods.GET) && accepted != null
            && accepted.contains(HTML) && !exchange.getRequestPath().startsWith(CALLS)) {
            send(exchange, status, "login.html", "");
        } else if (status == StatusCodes.TOO_MANY_REQUESTS) {
            exchange.getResponseHeaders().put(Headers.RETRY_AFTER, String.valueOf(TokenAttempts.WINDOW_SECONDS));
            Guard.refuse(exchange, status, TOO_MANY);
        } else if (status == StatusCodes.NOT_FOUND) {
            Guard.refuse(exchange, status, "there is nothing to read here");
        } else {
            Guard.refuse(exchange, status, "this server requires the token that it printed at its start: "
                + "send it in the header Authorization: Bearer TOKEN");
        }
    }

    private static void send(HttpServerExchange exchange, int status, String page, String message) {
        try (InputStream in = Login.class.getResourceAsStream(page)) {
            String text = new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("MESSAGE", message);
            exchange.setStatusCode(status);
            exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, HTML + "; charset=utf-8")
                .put(Headers.CACHE_CONTROL, "no-store").put(CONTENT_POLICY, PAGE_POLICY);
            exchange.getResponseSender().send(text);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
