package org.myrobotlab.embedded;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.TimeoutException;

/** Answers that somebody waits for. Any thread. */
final class Replies {
    /** Status of a message whose sender waits for the answer. */
    static final String BLOCKING = "B";

    private static final Map<Long, CompletableFuture<Object>> WAITED_FOR = new ConcurrentHashMap<>();

    private Replies() {
    }

    /** Before the message is sent. */
    static void expect(Message msg) {
        msg.status = BLOCKING;
        WAITED_FOR.put(msg.msgId, new CompletableFuture<>());
    }

    static void answer(Message msg, Object value) {
        CompletableFuture<Object> reply = WAITED_FOR.get(msg.msgId);
        if (reply != null) {
            reply.complete(value);
        }
    }

    static Object await(Message msg, Integer timeoutMs) throws InterruptedException, TimeoutException {
        CompletableFuture<Object> reply = WAITED_FOR.get(msg.msgId);
        try {
            return timeoutMs == null ? reply.get() : reply.get(timeoutMs, TimeUnit.MILLISECONDS);
        } catch (ExecutionException e) {
            throw new IllegalStateException(e.getCause());
        } catch (java.util.concurrent.TimeoutException e) {
            throw new TimeoutException("%s did not answer %s within %d ms", msg.name, msg.method, timeoutMs);
        } finally {
            WAITED_FOR.remove(msg.msgId);
        }
    }
}
