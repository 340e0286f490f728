// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.io.Serializable;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import org.myrobotlab.framework.interfaces.MessageListener;

/** Messages to one service, first in, first out. Any thread. */
public class Inbox implements Serializable {
    private static final long serialVersionUID = 1L;

    private final String owner;
    private final transient BlockingQueue<Message> messages = new LinkedBlockingQueue<>();
    private final transient List<MessageListener> watchers = new CopyOnWriteArrayList<>();

    public Inbox() {
        this("inbox");
    }

    public Inbox(String name) {
        owner = name;
    }

    public void add(Message msg) {
        messages.add(msg);
        for (MessageListener watcher : watchers) {
            watcher.onMessage(msg);
        }
    }

    /** Waits for the next message. */
    public Message getMsg() throws InterruptedException {
        return messages.take();
    }

    /** Also passes each incoming message to a listener. */
    public void addMessageListener(MessageListener listener) {
        watchers.add(listener);
    }

    public void clear() {
        messages.clear();
    }

    public int size() {
        return messages.size();
    }

    @Override
    public String toString() {
        return owner + " inbox, " + size() + " messages";
    }
}
