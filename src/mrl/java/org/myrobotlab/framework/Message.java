// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.io.Serializable;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import org.myrobotlab.codec.CodecUtils;

/** A method call on its way from one service to another. */
public class Message implements Serializable {
    private static final long serialVersionUID = 1L;
    private static final AtomicLong LAST_ID = new AtomicLong();

    /** Unique in this process. */
    public long msgId;
    /** Receiver; null until the outbox has found the listeners. */
    public String name;
    /** Name of the sending service. */
    public String sender;
    /** Method that the sender published. */
    public String sendingMethod;
    /** B while the sender waits for the answer, else null. */
    public String status;
    /** Encoding of {@link #data}: json, or null for plain objects. */
    public String encoding;
    /** Method to call. */
    public String method;
    /** Arguments; null for none. */
    public transient Object[] data;

    public Message() {
        msgId = LAST_ID.incrementAndGet();
        sendingMethod = "";
    }

    public Message(Message other) {
        set(other);
    }

    /** Copies all fields of another message. */
    public final void set(Message other) {
        msgId = other.msgId;
        name = other.name;
        sender = other.sender;
        sendingMethod = other.sendingMethod;
        status = other.status;
        encoding = other.encoding;
        method = other.method;
        data = other.data;
    }

    /** Creates a message with several arguments. */
    public static Message createMessage(String sender, String name, String method, Object[] data) {
        Message msg = new Message();
        msg.sender = sender;
        msg.name = name;
        msg.method = method;
        msg.data = data;
        return msg;
    }

    /** Creates a message with one argument, or none if it is null. */
    public static Message createMessage(String sender, String name, String method, Object data) {
        return createMessage(sender, name, method, data == null ? null : new Object[] {data});
    }

    public Object[] getData() {
        return data;
    }

    public final void setData(Object... newData) {
        data = newData;
    }

    public String getName() {
        return name;
    }

    public void setName(String newName) {
        name = newName;
    }

    public String getMethod() {
        return method;
    }

    public long getMsgId() {
        return msgId;
    }

    /** Returns the receiver with the process id. */
    public String getFullName() {
        return name == null ? null : CodecUtils.getFullName(name);
    }

    /** Returns the sender without the process id. */
    public String getSrcName() {
        return sender == null ? null : CodecUtils.getShortName(sender);
    }

    @Override
    public String toString() {
        return sender + "." + sendingMethod + " --> " + name + "." + method + "("
            + (data == null ? "" : Arrays.deepToString(data)) + ")";
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Message && msgId == ((Message) other).msgId;
    }

    @Override
    public int hashCode() {
        return Long.hashCode(msgId);
    }
}
