package org.myrobotlab.embedded.web;

import io.undertow.websockets.core.WebSocketCallback;
import io.undertow.websockets.core.WebSocketChannel;
import io.undertow.websockets.core.WebSockets;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;

/** A page that is open in a browser. Any thread. */
final class Client {
    /** Messages that may wait for a slow page; values that come then are left out. */
    private static final int MOST_WAITING = 200;

    private final WebSocketChannel channel;
    private final Set<String> topics = ConcurrentHashMap.newKeySet();
    /** What is still to be done; the first is being done. */
    private final Queue<Runnable> tasks = new ArrayDeque<>();
    private final AtomicInteger waiting = new AtomicInteger();
    private final WebSocketCallback<Void> sent = new WebSocketCallback<Void>() {
        @Override
        public void complete(WebSocketChannel unused, Void nothing) {
            waiting.decrementAndGet();
        }

        @Override
        public void onError(WebSocketChannel unused, Void nothing, Throwable error) {
            waiting.decrementAndGet();
        }
    };

    Client(WebSocketChannel channel) {
        this.channel = channel;
    }

    /** Sends a text. */
    void send(String text) {
        waiting.incrementAndGet();
        WebSockets.sendText(text, channel, sent);
    }

    /** Sends one of many values; leaves it out while the page can't keep up. */
    void sendValue(String text) {
        if (waiting.get() < MOST_WAITING) {
            send(text);
        }
    }

    /** Has work done after all that was given before: parts of an upload must not overtake each other. */
    void inOrder(Executor worker, Runnable work) {
        synchronized (tasks) {
            tasks.add(work);
            if (tasks.size() > 1) {
                return;
            }
        }
        worker.execute(() -> workOff(worker));
    }

    private void workOff(Executor worker) {
        Runnable work;
        synchronized (tasks) {
            work = tasks.peek();
        }
        try {
            work.run();
        } finally {
            boolean more;
            synchronized (tasks) {
                tasks.remove();
                more = !tasks.isEmpty();
            }
            if (more) {
                worker.execute(() -> workOff(worker));
            }
        }
    }

    void subscribe(String service, String topic) {
        topics.add(service + "/" + topic);
    }

    void unsubscribe(String service, String topic) {
        topics.remove(service + "/" + topic);
    }

    boolean wants(String service, String topic) {
        return topics.contains(service + "/" + topic);
    }

    /** The topics of a service that the page listens to. */
    Set<String> topicsOf(String service) {
        Set<String> found = new TreeSet<>();
        String prefix = service + "/";
        topics.stream().filter(one -> one.startsWith(prefix)).forEach(one -> found.add(one.substring(prefix.length())));
        return found;
    }
}
