// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.websockets.core.AbstractReceiveListener;
import io.undertow.websockets.core.StreamSourceFrameChannel;
import io.undertow.websockets.core.WebSocketCallback;
import io.undertow.websockets.core.WebSocketChannel;
import io.undertow.websockets.core.WebSockets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.embedded.Json;
import org.myrobotlab.embedded.ErrorReasons;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.Runtime;
import org.slf4j.Logger;
import org.xnio.IoUtils;
import org.xnio.XnioExecutor;

/**
 * Messages between services and open pages, as JSON over a web socket.
 *
 * <p>From a page: {@code {"name":"lidar","method":"connect","data":["COM4",9600]}} calls a method; {@code
 * {"subscribe":"lidar","topic":"publishScan"}} and {@code {"unsubscribe":...}} begin and end a subscription;
 * {@code "id"} in a call asks for an answer. To a page: {@code {"name":"lidar","method":"onScan","data":[...]}}, {@code
 * {"id":7,"answer":...}} or {@code {"id":7,"error":"..."}}, and {@code {"services":[...]}} when a service starts or
 * stops. Any thread.
 */
public final class Hub {
    private static final Logger LOG = LoggerFactory.getLogger(Hub.class);
    /** Limit of open pages. */
    static final int MAX_PAGES = 32;
    /**
     * Interval of pings, s. After a quarter of an hour without a route to the page the system closes the connection.
     */
    private static final int PING_SECONDS = 10;
    /** Silence after which a page may be replaced, ns; nothing else shows that its computer is gone. */
    private static final long SILENT_NANOS = TimeUnit.SECONDS.toNanos(60);
    /** Close code of web sockets, registered for RFC 6455. */
    private static final int TRY_AGAIN_LATER = 1013;
    /** Topics that slow pages get nevertheless, because the next message may be long in coming. */
    private static final Set<String> NEVER_LEFT_OUT = Set.of("publishState", "publishStatus", "getBundle");

    private final String listener;
    private final LongSupplier clock;
    private final Set<PageClient> clients = ConcurrentHashMap.newKeySet();
    private final MessageRoom room = new MessageRoom();
    /** Services that pages know. */
    private final Set<String> reported = ConcurrentHashMap.newKeySet();

    /** @param listener name of the service that listens for the pages and passes messages to {@link #forward} */
    public Hub(String listener) {
        this(listener, System::nanoTime);
    }

    /** @param clock nanoseconds */
    Hub(String listener, LongSupplier clock) {
        this.listener = listener;
        this.clock = clock;
    }

    /**
     * Connects a page.
     *
     * @param calls runs the page's calls
     */
    void connect(WebSocketChannel channel, PageCalls calls) {
        PageClient client = new PageClient(channel, clock, () -> clients.stream().mapToLong(PageClient::unread).sum());
        if (clients.size() >= MAX_PAGES && !closeSilent()) {
            refuse(channel);
            return;
        }
        XnioExecutor.Key pings;
        try {
            pings = channel.getIoThread().executeAtInterval(client::ping, PING_SECONDS, TimeUnit.SECONDS);
        } catch (RejectedExecutionException e) {
            LOG.debug("closed a page that connected while the server stops", e);
            client.close();
            return;
        }
        clients.add(client);
        OpenPages.come();
        TextReader reader = new TextReader(channel, room, (text, bytes) -> client.inOrder(calls::execute, () -> {
            try {
                receive(client, calls, text);
            } finally {
                room.release(bytes);
            }
        }));
        Runnable gone = () -> {
            pings.remove();
            reader.close();
            forget(client);
        };
        channel.addCloseTask(closed -> gone.run());
        if (!channel.isOpen()) {
            gone.run();     // closed before the close task was set
        }
        client.send(services());
        channel.getReceiveSetter().set(new AbstractReceiveListener() {
            /** Undertow throws at a length of 2^63 and more, and stops reading: the page's end would go unnoticed. */
            @Override
            public void handleEvent(WebSocketChannel from) {
                client.hear();
                try {
                    super.handleEvent(from);
                } catch (RuntimeException e) {
                    LOG.debug("closed a page that sent an invalid frame", e);
                    IoUtils.safeClose(from);
                }
            }

            @Override
            protected void onText(WebSocketChannel from, StreamSourceFrameChannel message) {
                reader.read(message);
            }

            @Override
            protected void onBinary(WebSocketChannel from, StreamSourceFrameChannel message) {
                LOG.debug("closed a page that sent binary data");
                IoUtils.safeClose(from);
            }
        });
        channel.resumeReceives();
    }

    /** Closes the page that has been silent longest, if it is over the limit; returns whether it did. */
    private boolean closeSilent() {
        PageClient silent = clients.stream().max(Comparator.comparingLong(PageClient::silence))
            .filter(one -> one.silence() > SILENT_NANOS).orElse(null);
        if (silent == null) {
            return false;
        }
        LOG.debug("closed a page that has not answered for {} s", TimeUnit.NANOSECONDS.toSeconds(silent.silence()));
        silent.close();
        forget(silent);
        return true;
    }

    /** Closes the channel as soon as the reason is sent: without a reader the page's end would go unnoticed. */
    private static void refuse(WebSocketChannel channel) {
        WebSockets.sendClose(TRY_AGAIN_LATER, MAX_PAGES + " pages are open, which is the limit", channel,
            new WebSocketCallback<Void>() {
            @Override
            public void complete(WebSocketChannel sent, Void nothing) {
                IoUtils.safeClose(sent);
            }

            @Override
            public void onError(WebSocketChannel failed, Void nothing, Throwable error) {
                IoUtils.safeClose(failed);
            }
        });
    }

    private void receive(PageClient client, PageCalls calls, String text) {
        Object id = null;
        try {
            Map<?, ?> msg = Json.read(text, Map.class);
            id = msg.get("id");
            if (msg.containsKey("subscribe")) {
                subscribe(client, text(msg, "subscribe"), text(msg, "topic"));
            } else if (msg.containsKey("unsubscribe")) {
                unsubscribe(client, text(msg, "unsubscribe"), text(msg, "topic"));
            } else {
                call(client, calls, id, text(msg, "name"), text(msg, "method"), list(msg, "data"));
            }
        } catch (RuntimeException | StackOverflowError e) {
            fail(client, id, e);
        }
    }

    private static String text(Map<?, ?> msg, String key) {
        Object value = msg.get(key);
        if (!(value instanceof String)) {
            throw new IllegalArgumentException(key + " of a message is " + value + ", legal: a string");
        }
        return (String) value;
    }

    /** Returns a list, which is empty if the key is missing. */
    private static List<?> list(Map<?, ?> msg, String key) {
        Object value = msg.get(key);
        if (value != null && !(value instanceof List)) {
            throw new IllegalArgumentException(key + " of a message is not a list, legal: a list of arguments");
        }
        return value == null ? List.of() : (List<?>) value;
    }

    private static void fail(PageClient client, Object id, Throwable e) {
        LOG.debug("message {} failed", id, e);
        client.send(reply(id, "error", ErrorReasons.of(e)));
    }

    private synchronized void subscribe(PageClient client, String name, String topic) {
        if (!clients.contains(client)) {
            return;     // a message of a closed page; no one would end this subscription
        }
        client.subscribe(name, topic);
        ServiceInterface service = Runtime.getService(name);
        if (service != null) {
            service.addListener(topic, listener, CodecUtils.getCallbackTopicName(topic));
        }
    }

    private synchronized void unsubscribe(PageClient client, String name, String topic) {
        client.unsubscribe(name, topic);
        ServiceInterface service = Runtime.getService(name);
        if (service != null) {
            leave(service, topic);
        }
    }

    private synchronized void forget(PageClient client) {
        if (clients.remove(client)) {
            OpenPages.go();
        }
        Runtime.getServices().forEach(service -> client.topicsOf(service.getName())
            .forEach(topic -> leave(service, topic)));
    }

    /**
     * Stops listening to a topic that no page wants any more, except those of the Runtime, which the WebGui itself
     * needs.
     */
    private void leave(ServiceInterface service, String topic) {
        if (!(service instanceof Runtime) && clients.stream()
            .noneMatch(client -> client.wants(service.getName(), topic))) {
            service.removeListener(topic, listener, CodecUtils.getCallbackTopicName(topic));
        }
    }

    /**
     * Calls without "id" run on the service's own thread, in the page's order; calls with "id" run in parallel. A page
     * may call a service that has just been released, such as a port of a simulation. Such a call without "id" is
     * ignored, not an error.
     */
    private void call(PageClient client, PageCalls calls, Object id, String name, String method, List<?> data) {
        ServiceInterface service = Runtime.getService(name);
        if (service == null && id == null && reported.contains(name)) {
            LOG.debug("{} is gone: {} is ignored", name, method);
            return;
        }
        if (service == null) {
            throw new IllegalArgumentException("there is no service " + name);
        }
        Object[] arguments = JsonCall.arguments(service.getClass(), method, data);
        if (id == null) {
            service.in(Message.createMessage(listener, name, method, arguments));
        } else if (calls.enter()) {
            calls.execute(() -> {
                try {
                    client.send(reply(id, "answer", service.invoke(method, arguments)));
                } catch (RuntimeException | StackOverflowError e) {
                    fail(client, id, e);
                } finally {
                    calls.leave();
                }
            });
        } else {
            throw new IllegalStateException(PageCalls.FULL);
        }
    }

    private static String reply(Object id, String kind, Object value) {
        Map<String, Object> reply = new LinkedHashMap<>();
        reply.put("id", id);
        reply.put(kind, value);
        return Json.write(reply);
    }

    /** Sends a published message to the pages that listen. */
    public void forward(Message msg) {
        String name = CodecUtils.getShortName(msg.sender);
        String text = null;
        for (PageClient client : clients) {
            if (client.wants(name, msg.sendingMethod)) {
                text = text == null ? encoded(name, msg) : text;
                if (NEVER_LEFT_OUT.contains(msg.sendingMethod)) {
                    client.send(text);
                } else {
                    client.sendValue(name, msg.sendingMethod, text);
                }
            }
        }
    }

    private static String encoded(String name, Message msg) {
        Map<String, Object> plain = new LinkedHashMap<>();
        plain.put("name", name);
        plain.put("method", CodecUtils.getCallbackTopicName(msg.sendingMethod));
        plain.put("data", msg.data == null ? new Object[0] : PageMessages.data(msg.data));
        return Json.write(plain);
    }

    private synchronized void listen(ServiceInterface service) {
        clients.forEach(client -> client.topicsOf(service.getName()).forEach(topic ->
            service.addListener(topic, listener, CodecUtils.getCallbackTopicName(topic))));
    }

    /** Sends the list of services to all pages. Subscribes to new services first, before a page can see them. */
    public void reportServices() {
        String text = services();
        Runtime.getServices().forEach(this::listen);
        clients.forEach(client -> client.send(text));
    }

    private String services() {
        List<Map<String, Object>> all = new ArrayList<>();
        for (ServiceInterface service : Runtime.getServices()) {
            reported.add(service.getName());
            Map<String, Object> one = new LinkedHashMap<>();
            one.put("name", service.getName());
            one.put("simpleName", service.getSimpleName());
            one.put("typeKey", service.getTypeKey());
            one.put("methods", service.getMethodNames());
            one.put("running", service.isRunning());
            all.add(one);
        }
        return Json.write(Map.of("services", all));
    }
}
