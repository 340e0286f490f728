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
 * Stands before every page, file, call and web socket where a {@link Token} is asked for. The token comes in a link, {@code /?token=...}, which a
 * browser opens once, from the form of the login page, or in the header {@code Authorization: Bearer ...} of a program; nowhere else. A browser gets
 * a cookie for it, which is not the token, is named by the port, and is good for the address that the token came from.
 */
final class Login implements HttpHandler {
    private static final Logger LOG = LoggerFactory.getLogger(Login.class);
    private static final HttpString REFERRER_POLICY = new HttpString("Referrer-Policy");
    private static final HttpString CONTENT_POLICY = new HttpString("Content-Security-Policy");
    private static final String PAGE_POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; form-action 'self'; "
        + "frame-ancestors 'none'; base-uri 'none'";
    private static final String BEARER = "Bearer ";
    private static final String TOKEN = "token";
    private static final String FORM = "/login";
    private static final String CALLS = "/api";
    private static final String HTML = "text/html";
    /** Of a form that is sent, bytes. */
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

    /** The token of a link to the first page; null if there is none. */
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
            Guard.refuse(exchange, StatusCodes.REQUEST_ENTITY_TOO_LARGE, "this is no token");
        } else {
            RequestBody.receive(exchange, (whole, body) -> enter(whole, judge(whole, field(body))));
        }
    }

    private static String field(String body) {
        try {
            return body.startsWith(TOKEN + "=") ? URLDecoder.decode(body.substring(TOKEN.length() + 1), StandardCharsets.UTF_8).trim() : "";
        } catch (IllegalArgumentException e) {
            return "";
        }
    }

    /** The right one always comes in, unless it is so short that it could be guessed: then nobody guesses on after too many wrong ones. */
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

    /** The cookie of another port of this computer has another name: a browser sends them all to all. */
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

    /** One of several of the same name is enough: pages of other ports may add some. */
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
     * What a link or the form is answered. The way on is a page's own: a cookie that is so strict is not sent to where another page's link redirects.
     */
    private void enter(HttpServerExchange exchange, int status) {
        if (status == StatusCodes.OK) {
            exchange.getResponseHeaders().put(Headers.SET_COOKIE, cookie(exchange) + "; Path=/; HttpOnly; SameSite=Strict"
                + (names.isSecure(host(exchange)) ? "; Secure" : "")).put(REFERRER_POLICY, "no-referrer");
            send(exchange, status, "entered.html", "");
        } else {
            send(exchange, status, "login.html", status == StatusCodes.TOO_MANY_REQUESTS ? TOO_MANY : WRONG);
        }
    }

    /** Who has neither token nor cookie gets the login page, if it is a person. */
    private static void ask(HttpServerExchange exchange, int status) {
        exchange.getResponseHeaders().put(Headers.WWW_AUTHENTICATE, BEARER.trim());
        String accepted = exchange.getRequestHeaders().getFirst(Headers.ACCEPT);
        if (status == StatusCodes.UNAUTHORIZED && Guard.is(exchange, Methods.GET) && accepted != null && accepted.contains(HTML)
            && !exchange.getRequestPath().startsWith(CALLS)) {
            send(exchange, status, "login.html", "");
        } else if (status == StatusCodes.TOO_MANY_REQUESTS) {
            exchange.getResponseHeaders().put(Headers.RETRY_AFTER, String.valueOf(TokenAttempts.WINDOW_SECONDS));
            Guard.refuse(exchange, status, TOO_MANY);
        } else if (status == StatusCodes.NOT_FOUND) {
            Guard.refuse(exchange, status, "there is nothing to read here");
        } else {
            Guard.refuse(exchange, status, "this server asks for a token, which was printed when it started: "
                + "send it in the header Authorization: Bearer TOKEN");
        }
    }

    private static void send(HttpServerExchange exchange, int status, String page, String message) {
        try (InputStream in = Login.class.getResourceAsStream(page)) {
            String text = new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("MESSAGE", message);
            exchange.setStatusCode(status);
            exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, HTML + "; charset=utf-8").put(Headers.CACHE_CONTROL, "no-store")
                .put(CONTENT_POLICY, PAGE_POLICY);
            exchange.getResponseSender().send(text);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
