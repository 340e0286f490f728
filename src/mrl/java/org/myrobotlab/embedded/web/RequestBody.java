// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.server.HttpServerExchange;
import io.undertow.util.StatusCodes;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Executor;
import java.util.concurrent.Semaphore;
import java.util.function.BiConsumer;
import org.xnio.IoUtils;

/**
 * Receives the body of a request without a waiting thread and passes it on when complete. Limits the memory of all
 * incomplete bodies; {@link Connections} limits the time of each.
 */
final class RequestBody {
    /** Limit of one body, bytes: at most a sixteenth of the memory, of which text and arguments take several parts. */
    static final int LONGEST = (int) Math.min(16 << 20, Runtime.getRuntime().maxMemory() / 16);
    /** Limit of all incomplete bodies, bytes. */
    private static final int LARGEST_SUM = (int) Math.min(64 << 20, Runtime.getRuntime().maxMemory() / 8);
    private static final Semaphore ROOM = new Semaphore(LARGEST_SUM);

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final BiConsumer<HttpServerExchange, String> taker;
    private boolean isRefused;

    private RequestBody(BiConsumer<HttpServerExchange, String> taker) {
        this.taker = taker;
    }

    /**
     * Receives a body on the connection's own thread.
     *
     * @param taker gets the text, on that thread
     */
    static void receive(HttpServerExchange exchange, BiConsumer<HttpServerExchange, String> taker) {
        RequestBody body = new RequestBody(taker);
        if (exchange.getRequestContentLength() > LONGEST) {
            body.refuseLong(exchange);
            return;
        }
        exchange.addExchangeCompleteListener((ended, next) -> {
            body.forget();
            next.proceed();
        });
        exchange.getRequestReceiver().receivePartialBytes((from, part, last) -> {
            body.take(from, part);
            if (last) {
                body.handOn(from);
            }
        }, (from, error) -> IoUtils.safeClose(from.getConnection()));
    }

    private synchronized void take(HttpServerExchange exchange, byte... part) {
        if (isRefused) {
            return;
        }
        if (bytes.size() + part.length > LONGEST) {
            refuseLong(exchange);
        } else if (!ROOM.tryAcquire(part.length)) {
            refuse(exchange, StatusCodes.SERVICE_UNAVAILABLE, "too many large calls are in progress: try again");
        } else {
            bytes.write(part, 0, part.length);
        }
    }

    private void refuseLong(HttpServerExchange exchange) {
        refuse(exchange, StatusCodes.REQUEST_ENTITY_TOO_LARGE, "the arguments are longer than "
            + (LONGEST >> 20) + " MB");
    }

    private synchronized void refuse(HttpServerExchange exchange, int status, String why) {
        forget();
        isRefused = true;
        exchange.setPersistent(false);
        Guard.refuse(exchange, status, why);
    }

    /**
     * Calls the taker after this connection's thread has left the receiver. If another thread answered while the
     * receiver still returns, the connection could stay suspended and never read its next request.
     */
    private void handOn(HttpServerExchange exchange) {
        String text = whole();
        if (text != null) {
            exchange.dispatch((Executor) exchange.getIoThread(), () -> taker.accept(exchange, text));
        }
    }

    /** Returns the text; null if the body was rejected. */
    private synchronized String whole() {
        if (isRefused) {
            return null;
        }
        String text = bytes.toString(StandardCharsets.UTF_8);
        forget();
        return text;
    }

    private synchronized void forget() {
        ROOM.release(bytes.size());
        bytes.reset();
    }
}
