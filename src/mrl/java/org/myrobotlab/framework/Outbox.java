// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.io.Serializable;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.framework.interfaces.MessageListener;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.Runtime;
import org.slf4j.Logger;

/** Messages from one service to the inboxes of its listeners. One thread sends them in order; any thread may add. */
public class Outbox implements Runnable, Serializable {
    public static final Logger log = LoggerFactory.getLogger(Outbox.class);

    private static final long serialVersionUID = 1L;
    private static final int MOST = 1024;

    protected final String name;
    /** Listeners by published method. The map used here is serialisable, unlike its declared type. */
    @SuppressWarnings("serial")
    protected final Map<String, List<MRLListener>> notifyList = new ConcurrentHashMap<>();
    private final transient BlockingQueue<Message> messages = new LinkedBlockingQueue<>();
    private final transient List<MessageListener> watchers = new CopyOnWriteArrayList<>();
    private transient volatile Thread thread;

    public Outbox(String serviceName) {
        name = serviceName;
    }

    /**
     * Sends a message; one without a receiver goes to all listeners of its sending method. Every message waits here, as
     * in the real MyRobotLab, even without listeners. Logs a warning each time more than 1024 wait; none is lost.
     */
    public void add(Message msg) {
        int waiting = messages.size();
        if (waiting == MOST + 1) {
            log.warn("{} outbox BUFFER OVERRUN size {} {}", name, waiting, msg.sendingMethod);
        }
        messages.add(msg);
        for (MessageListener watcher : watchers) {
            watcher.onMessage(msg);
        }
    }

    @Override
    public void run() {
        try {
            while (isRunning()) {
                deliver(messages.take());
            }
        } catch (InterruptedException e) {
            log.debug("{}: outbox closed", name);
        }
    }

    private void deliver(Message msg) {
        if (msg.name != null) {
            send(msg);
            return;
        }
        for (MRLListener listener : notifyList.getOrDefault(msg.sendingMethod, List.of())) {
            Message copy = new Message(msg);
            copy.name = listener.callbackName;
            copy.method = listener.callbackMethod;
            send(copy);
        }
    }

    /** Puts a message directly into its receiver's inbox. */
    public final void send(Message msg) {
        ServiceInterface receiver = Runtime.getService(msg.name);
        if (receiver == null) {
            log.info("{}: no service {} to take {}", name, msg.name, msg.method);
        } else {
            receiver.in(msg);
        }
    }

    /** Starts the thread. */
    public synchronized void start() {
        if (thread == null) {
            thread = new Thread(this, name + "_outbox");
            thread.setDaemon(true);
            thread.start();
        }
    }

    /** Ends the thread. */
    public synchronized void stop() {
        if (thread != null) {
            thread.interrupt();
            thread = null;
        }
    }

    public boolean isRunning() {
        return thread != null;
    }

    public int size() {
        return messages.size();
    }

    public Map<String, List<MRLListener>> getNotifyList() {
        return notifyList;
    }

    /** Also passes each outgoing message to a listener. */
    public void addMessageListener(MessageListener listener) {
        watchers.add(listener);
    }

    /** Returns the names of the listeners of a method; of all methods if null. */
    public Set<String> getAttached(String publishingPoint) {
        Set<String> names = new TreeSet<>();
        notifyList.forEach((topic, listeners) -> {
            if (publishingPoint == null || publishingPoint.equals(topic)) {
                listeners.forEach(listener -> names.add(listener.callbackName));
            }
        });
        return names;
    }

    /** Removes all listeners of that name. */
    public synchronized void detach(String serviceName) {
        for (List<MRLListener> listeners : notifyList.values()) {
            listeners.removeIf(listener -> CodecUtils.checkServiceNameEquality(listener.callbackName, serviceName));
        }
    }

    /** Removes all listeners. */
    public void reset() {
        notifyList.clear();
    }
}
