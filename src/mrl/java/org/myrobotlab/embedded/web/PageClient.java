// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.websockets.core.WebSocketCallback;
import io.undertow.websockets.core.WebSocketChannel;
import io.undertow.websockets.core.WebSockets;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import org.xnio.IoUtils;

/** A page that is open in a browser. Any thread. */
final class PageClient {
    /** Limit of waiting values per topic; a slow page misses further ones. */
    private static final int MAX_WAITING = 200;
    /** Limit of unsent characters of all pages; beyond it those with more than an even share are closed. */
    private static final long MAX_UNREAD_SUM = Math.min(64L << 20, Runtime.getRuntime().maxMemory() / 4);
    /** Limit of unsent characters; beyond it the page counts as not reading and is closed. */
    private static final long MAX_UNREAD = MAX_UNREAD_SUM / 2;
    /** Limit of a page's messages that wait for their turn; further ones wait in the connection. */
    private static final int MAX_TASKS = 100;
    private static final int MAX_TOPICS = 10_000;

    private final WebSocketChannel channel;
    private final Set<String> topics = ConcurrentHashMap.newKeySet();
    /** Pending work; the first is in progress. */
    private final Queue<Runnable> tasks = new ArrayDeque<>();
    /** Unsent values by topic: the single bytes of a serial port must not crowd out scans. */
    private final Map<String, AtomicInteger> waiting = new ConcurrentHashMap<>();
    private final AtomicLong unread = new AtomicLong();
    private final AtomicInteger pings = new AtomicInteger();
    private final LongSupplier clock;
    private final LongSupplier unreadByAll;
    private volatile long heard;

    /**
     * @param clock nanoseconds
     * @param unreadByAll unsent characters of all pages
     */
    PageClient(WebSocketChannel channel, LongSupplier clock, LongSupplier unreadByAll) {
        this.channel = channel;
        this.clock = clock;
        this.unreadByAll = unreadByAll;
        heard = clock.getAsLong();
    }

    /** Sends a ping, unless the last one is still unsent. */
    void ping() {
        if (pings.get() == 0) {
            WebSockets.sendPing(ByteBuffer.allocate(0), channel, new Sent(pings, 0));
        }
    }

    /** Notes that the page has sent something. */
    void hear() {
        heard = clock.getAsLong();
    }

    /** Returns the time since the page sent something, ns. */
    long silence() {
        return clock.getAsLong() - heard;
    }

    /** Closes the connection without a close message. */
    void close() {
        IoUtils.safeClose(channel);
    }

    /** Sends a text. */
    void send(String text) {
        send(text, new AtomicInteger());
    }

    private void send(String text, AtomicInteger count) {
        if (isBehind(unread.get())) {
            close();
        } else {
            WebSockets.sendText(text, channel, new Sent(count, text.length()));
        }
    }

    private boolean isBehind(long own) {
        return own > MAX_UNREAD || own > MAX_UNREAD_SUM / Hub.MAX_PAGES && unreadByAll.getAsLong() > MAX_UNREAD_SUM;
    }

    /** Returns the number of unsent characters. */
    long unread() {
        return unread.get();
    }

    /** Sends a value of a topic, or drops it if the page is too slow for the topic. */
    void sendValue(String service, String topic, String text) {
        AtomicInteger count = waiting.computeIfAbsent(service + "/" + topic, unused -> new AtomicInteger());
        if (count.get() < MAX_WAITING) {
            send(text, count);
        }
    }

    /** Runs work after all earlier work: parts of an upload must stay in order. */
    void inOrder(Executor worker, Runnable work) {
        synchronized (tasks) {
            tasks.add(work);
            if (tasks.size() >= MAX_TASKS) {
                channel.suspendReceives();
            }
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
                if (tasks.size() == MAX_TASKS - 1) {
                    channel.resumeReceives();
                }
            }
            if (more) {
                worker.execute(() -> workOff(worker));
            }
        }
    }

    /** @throws IllegalArgumentException if the page listens to too many topics */
    void subscribe(String service, String topic) {
        if (topics.size() >= MAX_TOPICS) {
            throw new IllegalArgumentException("a page may listen to at most " + MAX_TOPICS + " topics");
        }
        topics.add(service + "/" + topic);
    }

    void unsubscribe(String service, String topic) {
        topics.remove(service + "/" + topic);
    }

    boolean wants(String service, String topic) {
        return topics.contains(service + "/" + topic);
    }

    /** Returns the topics of a service that the page listens to. */
    Set<String> topicsOf(String service) {
        Set<String> found = new TreeSet<>();
        String prefix = service + "/";
        topics.stream().filter(one -> one.startsWith(prefix)).forEach(one -> found.add(one.substring(prefix.length())));
        return found;
    }

    /** Counts a message from its sending until it is delivered or has failed. */
    private final class Sent implements WebSocketCallback<Void> {
        private final AtomicInteger count;
        private final int length;

        Sent(AtomicInteger count, int length) {
            this.count = count;
            this.length = length;
            count.incrementAndGet();
            unread.addAndGet(length);
        }

        @Override
        public void complete(WebSocketChannel to, Void nothing) {
            count.decrementAndGet();
            unread.addAndGet(-length);
        }

        @Override
        public void onError(WebSocketChannel to, Void nothing, Throwable error) {
            complete(to, nothing);
        }
    }
}
