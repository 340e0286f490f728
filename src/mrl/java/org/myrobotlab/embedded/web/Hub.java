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
 * <p>From a page: {@code {"name":"lidar","method":"connect","data":["COM4",9600]}} calls; {@code {"subscribe":"lidar","topic":"publishScan"}} and
 * {@code {"unsubscribe":...}} begin and end a subscription; {@code "id"} in a call asks for an answer. To a page:
 * {@code {"name":"lidar","method":"onScan","data":[...]}}, {@code {"id":7,"answer":...}} or {@code {"id":7,"error":"..."}}, and
 * {@code {"services":[...]}} when a service comes or goes. Any thread.
 */
public final class Hub {
    private static final Logger LOG = LoggerFactory.getLogger(Hub.class);
    /** Each may keep a message of {@link RequestBody#LONGEST} in memory while it comes in. */
    private static final int MAX_PAGES = 32;
    /** A page is asked so often whether it is there; where it can't be reached for a quarter of an hour, the system closes its connection. */
    private static final int PING_SECONDS = 10;
    /** One that has not answered for so long makes way for another: of a computer that has vanished nothing else tells. */
    private static final long SILENT_NANOS = TimeUnit.SECONDS.toNanos(60);
    /** Why a web socket is closed, as registered for RFC 6455. */
    private static final int TRY_AGAIN_LATER = 1013;
    /** What a slow page gets all the same: the next one of these may be long in coming. */
    private static final Set<String> NEVER_LEFT_OUT = Set.of("publishState", "publishStatus", "getBundle");

    private final String listener;
    private final LongSupplier clock;
    private final Set<PageClient> clients = ConcurrentHashMap.newKeySet();
    /** Names of the services of which pages were told. */
    private final Set<String> reported = ConcurrentHashMap.newKeySet();

    /** @param listener name of the service that listens in place of the pages, and gives what it hears to {@link #forward} */
    public Hub(String listener) {
        this(listener, System::nanoTime);
    }

    /** @param clock nanoseconds */
    Hub(String listener, LongSupplier clock) {
        this.listener = listener;
        this.clock = clock;
    }

    /**
     * A page has come.
     *
     * @param calls where what it calls runs
     */
    void connect(WebSocketChannel channel, PageCalls calls) {
        PageClient client = new PageClient(channel, clock);
        if (clients.size() >= MAX_PAGES && !closeSilent()) {
            refuse(channel);
            return;
        }
        XnioExecutor.Key pings;
        try {
            pings = channel.getIoThread().executeAtInterval(client::ping, PING_SECONDS, TimeUnit.SECONDS);
        } catch (RejectedExecutionException e) {
            LOG.debug("a page came while the server stops: closed", e);
            client.close();
            return;
        }
        clients.add(client);
        OpenPages.come();
        Runnable gone = () -> {
            pings.remove();
            forget(client);
        };
        channel.addCloseTask(closed -> gone.run());
        if (!channel.isOpen()) {
            gone.run();     // it was closed before the task was there
        }
        client.send(services());
        channel.getReceiveSetter().set(new AbstractReceiveListener() {
            /** Undertow throws at a length of 2^63 and more, and reads no further: nobody would see that the page has gone. */
            @Override
            public void handleEvent(WebSocketChannel from) {
                client.hear();
                try {
                    super.handleEvent(from);
                } catch (RuntimeException e) {
                    LOG.debug("a page sent what is no frame: closed", e);
                    IoUtils.safeClose(from);
                }
            }

            @Override
            protected void onText(WebSocketChannel from, StreamSourceFrameChannel message) {
                TextReader.read(message, RequestBody.LONGEST, text -> client.inOrder(calls::execute, () -> receive(client, calls, text)));
            }

            @Override
            protected void onBinary(WebSocketChannel from, StreamSourceFrameChannel message) {
                LOG.debug("a page sent bytes, which nothing here takes: closed");
                IoUtils.safeClose(from);
            }
        });
        channel.resumeReceives();
    }

    /** Answers whether a page was silent for so long that it had to go: the one that was for the longest time. */
    private boolean closeSilent() {
        PageClient silent = clients.stream().max(Comparator.comparingLong(PageClient::silence))
            .filter(one -> one.silence() > SILENT_NANOS).orElse(null);
        if (silent == null) {
            return false;
        }
        LOG.debug("a page has not answered for {} s: closed", TimeUnit.NANOSECONDS.toSeconds(silent.silence()));
        silent.close();
        forget(silent);
        return true;
    }

    /** Nobody reads from the channel any more, so nobody would see that its page has gone: it is closed at once when the reason is sent. */
    private static void refuse(WebSocketChannel channel) {
        WebSockets.sendClose(TRY_AGAIN_LATER, MAX_PAGES + " pages are open, the most that may", channel, new WebSocketCallback<Void>() {
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
            throw new IllegalArgumentException(key + " of a message is " + value + ", legal: a text");
        }
        return (String) value;
    }

    /** A list; an empty one if there is none. */
    private static List<?> list(Map<?, ?> msg, String key) {
        Object value = msg.get(key);
        if (value != null && !(value instanceof List)) {
            throw new IllegalArgumentException(key + " of a message is no list, legal: a list of arguments");
        }
        return value == null ? List.of() : (List<?>) value;
    }

    private static void fail(PageClient client, Object id, Throwable e) {
        LOG.debug("message {} failed", id, e);
        client.send(reply(id, "error", ErrorReasons.of(e)));
    }

    private synchronized void subscribe(PageClient client, String name, String topic) {
        if (!clients.contains(client)) {
            return;     // what it has sent before it went is worked off after that, and nobody would end the subscription
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
        Runtime.getServices().forEach(service -> client.topicsOf(service.getName()).forEach(topic -> leave(service, topic)));
    }

    /** What no page wants any more is no longer heard. Only the Runtime is: of it the WebGui itself wants to know who comes and goes. */
    private void leave(ServiceInterface service, String topic) {
        if (!(service instanceof Runtime) && clients.stream().noneMatch(client -> client.wants(service.getName(), topic))) {
            service.removeListener(topic, listener, CodecUtils.getCallbackTopicName(topic));
        }
    }

    /**
     * Calls without "id" run on the service's own thread, in the page's order; calls that want an answer run beside each other. A page that was told
     * of a service may call it before it hears that it has gone, as the ports of a simulation go: then there is nobody to hear it, and no error.
     */
    private void call(PageClient client, PageCalls calls, Object id, String name, String method, List<?> data) {
        ServiceInterface service = Runtime.getService(name);
        if (service == null && id == null && reported.contains(name)) {
            LOG.debug("{} has gone: nobody hears {}", name, method);
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

    /** Gives what a service published to the pages that listen to it. */
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

    /** Tells all pages which services there are. One that has just been registered is listened to before a page can see it. */
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
