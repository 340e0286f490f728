// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.Methods;
import io.undertow.util.StatusCodes;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Executor;
import org.myrobotlab.embedded.Json;
import org.myrobotlab.embedded.ErrorReasons;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Runtime;

/**
 * Calls over HTTP: {@code POST /api/service/NAME/METHOD} with a JSON list of arguments as body; the answer is JSON.
 * {@code GET /api/service} lists the services, {@code GET /api/service/NAME} returns a service's state, and
 * {@code GET /api/service/NAME/METHOD/ARG/...} calls one of a few methods that only read.
 */
final class RestHandler implements HttpHandler {
    /** Methods that change nothing, in any service. */
    private static final Set<String> READING = Set.of("getName", "getType", "getSimpleName", "getMethodNames",
        "isRunning", "isConnected",
        "isSimulating", "isPaused", "isLockStep", "getTime", "getSensorNames", "getSensorUnit", "getReading", "getPose",
        "getDistanceResult",
        "getLidarResult", "getGpsResult", "getCompassResult", "getAccelResult", "getGyroResult", "getPortNames",
            "getUnit", "getServiceNames");
    private static final int NAME = 0;
    private static final int METHOD = 1;
    private static final int ARGUMENTS = 2;

    private final PageCalls calls;

    RestHandler(PageCalls calls) {
        this.calls = calls;
    }

    @Override
    public void handleRequest(HttpServerExchange exchange) {
        List<String> path = new ArrayList<>(Arrays.asList(exchange.getRelativePath().split("/")));
        path.removeIf(String::isEmpty);
        if (Guard.is(exchange, Methods.POST)) {
            RequestBody.receive(exchange, (whole, body) -> dispatch(whole, () -> post(path, body)));
        } else if (path.size() > METHOD && !READING.contains(path.get(METHOD))) {
            exchange.getResponseHeaders().put(Headers.ALLOW, "POST");
            Guard.refuse(exchange, StatusCodes.METHOD_NOT_ALLOWED, "call " + path.get(METHOD)
                + " by POST, with a JSON list of arguments");
        } else {
            dispatch(exchange, () -> get(path));
        }
    }

    /** An answer that may fail as a called method does. */
    private interface Answer {
        String get();
    }

    private void dispatch(HttpServerExchange exchange, Answer answer) {
        if (!calls.enter()) {
            Guard.refuse(exchange, StatusCodes.SERVICE_UNAVAILABLE, PageCalls.FULL);
            return;
        }
        exchange.dispatch((Executor) calls::execute, () -> {
            try {
                send(exchange, answer);
            } finally {
                calls.leave();
            }
        });
    }

    private static void send(HttpServerExchange exchange, Answer answer) {
        exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, "application/json");
        String text;
        try {
            text = answer.get();
        } catch (IllegalArgumentException e) {
            exchange.setStatusCode(StatusCodes.NOT_FOUND);
            text = Json.write(e.getMessage());
        } catch (RuntimeException | StackOverflowError e) {
            exchange.setStatusCode(StatusCodes.INTERNAL_SERVER_ERROR);
            text = Json.write(ErrorReasons.of(e));
        }
        exchange.getResponseSender().send(text + "\n");
    }

    private static String post(List<String> path, String body) {
        if (path.size() != ARGUMENTS) {
            throw new IllegalArgumentException("a call goes to /api/service/NAME/METHOD");
        }
        ServiceInterface service = service(path);
        Object answer = call(service, path.get(METHOD), body.isBlank() ? List.of() : Json.read(body, List.class));
        service.out(path.get(METHOD), answer);
        return Json.write(answer);
    }

    private static String get(List<String> path) {
        if (path.isEmpty()) {
            return Json.write(Runtime.getServiceNames());
        }
        ServiceInterface service = service(path);
        if (path.size() == METHOD) {
            return Json.write(service);
        }
        List<Object> values = new ArrayList<>();
        path.subList(ARGUMENTS, path.size()).forEach(one -> values.add(value(one)));
        return Json.write(call(service, path.get(METHOD), values));
    }

    private static ServiceInterface service(List<String> path) {
        ServiceInterface service = Runtime.getService(path.get(NAME));
        if (service == null) {
            throw new IllegalArgumentException("there is no service " + path.get(NAME));
        }
        return service;
    }

    /**
     * Reads a quoted argument as JSON, as MyRobotLab does, and any other as text: a sensor may be called {@code 1.50}
     * or {@code null}. Undertow decodes the path except for slashes.
     */
    private static Object value(String inPath) {
        String text = inPath.replaceAll("(?i)%2F", "/");
        try {
            return text.startsWith("\"") ? Json.read(text, String.class) : text;
        } catch (IllegalArgumentException e) {
            return text;
        }
    }

    private static Object call(ServiceInterface service, String name, List<?> json) {
        Object[] arguments = JsonCall.arguments(service.getClass(), name, json);
        try {
            Method method = org.myrobotlab.embedded.Methods.find(service.getClass(), name, arguments);
            return org.myrobotlab.embedded.Methods.call(service, method, arguments);
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(service.getName() + "." + name + ": " + ErrorReasons.of(e), e);
        }
    }
}
