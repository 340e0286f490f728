package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.Methods;
import io.undertow.util.StatusCodes;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.myrobotlab.embedded.Json;
import org.myrobotlab.embedded.Reasons;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Runtime;

/**
 * Calls over HTTP: {@code POST /api/service/NAME/METHOD} with a JSON list of arguments as body, or {@code GET /api/service/NAME/METHOD/ARG/...};
 * the answer is JSON. {@code GET /api/service} lists the services, {@code GET /api/service/NAME} is a service's state.
 */
final class RestHandler implements HttpHandler {
    private static final int NAME = 0;
    private static final int METHOD = 1;
    private static final int ARGUMENTS = 2;

    @Override
    public void handleRequest(HttpServerExchange exchange) throws IOException {
        if (exchange.isInIoThread()) {
            exchange.dispatch(this);
            return;
        }
        exchange.startBlocking();
        exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, "application/json");
        try {
            exchange.getResponseSender().send(answer(exchange) + "\n");
        } catch (IllegalArgumentException e) {
            exchange.setStatusCode(StatusCodes.NOT_FOUND);
            exchange.getResponseSender().send(Json.write(e.getMessage()) + "\n");
        } catch (IllegalStateException e) {
            exchange.setStatusCode(StatusCodes.INTERNAL_SERVER_ERROR);
            exchange.getResponseSender().send(Json.write(e.getMessage()) + "\n");
        }
    }

    private static String answer(HttpServerExchange exchange) throws IOException {
        List<String> path = new ArrayList<>(Arrays.asList(exchange.getRelativePath().split("/")));
        path.removeIf(String::isEmpty);
        if (path.isEmpty()) {
            return Json.write(Runtime.getServiceNames());
        }
        ServiceInterface service = Runtime.getService(path.get(NAME));
        if (service == null) {
            throw new IllegalArgumentException("there is no service " + path.get(NAME));
        }
        if (path.size() == METHOD) {
            return Json.write(service);
        }
        return call(service, path.get(METHOD), arguments(exchange, path));
    }

    private static List<?> arguments(HttpServerExchange exchange, List<String> path) throws IOException {
        if (exchange.getRequestMethod().equals(Methods.POST)) {
            String body = new String(exchange.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
            return body.isEmpty() ? List.of() : Json.read(body, List.class);
        }
        List<Object> values = new ArrayList<>();
        for (String one : path.subList(ARGUMENTS, path.size())) {
            values.add(value(one));
        }
        return values;
    }

    /** JSON, or else plain text. */
    private static Object value(String text) {
        try {
            return Json.read(text, Object.class);
        } catch (IllegalArgumentException e) {
            return text;
        }
    }

    private static String call(ServiceInterface service, String name, List<?> json) {
        Object[] arguments = JsonCall.arguments(service.getClass(), name, json);
        try {
            Object answer = org.myrobotlab.embedded.Methods.call(service,
                org.myrobotlab.embedded.Methods.find(service.getClass(), name, arguments), arguments);
            service.out(name, answer);
            return Json.write(answer);
        } catch (java.lang.reflect.InvocationTargetException e) {
            throw new IllegalStateException(service.getName() + "." + name + ": " + Reasons.of(e), e);
        }
    }
}
