package org.myrobotlab.framework;

import java.io.Serializable;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import org.myrobotlab.codec.CodecUtils;

/** A call of a method of a service, on its way from one service to another. */
public class Message implements Serializable {
    private static final long serialVersionUID = 1L;
    private static final AtomicLong LAST_ID = new AtomicLong();

    /** Unlike that of any other message of this process. */
    public long msgId;
    /** Whom it is for; null until the outbox has looked up who listens. */
    public String name;
    /** Who sent it. */
    public String sender;
    /** The method that the sender published. */
    public String sendingMethod;
    /** B while the sender waits for the answer, else null. */
    public String status;
    /** How {@link #data} is written: json, or null for plain objects. */
    public String encoding;
    /** The method to be called. */
    public String method;
    /** The arguments; null for none. */
    public transient Object[] data;

    public Message() {
        msgId = LAST_ID.incrementAndGet();
        sendingMethod = "";
    }

    public Message(Message other) {
        set(other);
    }

    /** Takes everything over from another message. */
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

    /** A message with several arguments. */
    public static Message createMessage(String sender, String name, String method, Object[] data) {
        Message msg = new Message();
        msg.sender = sender;
        msg.name = name;
        msg.method = method;
        msg.data = data;
        return msg;
    }

    /** A message with one argument, or none if it is null. */
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

    /** The name with the id of the process. */
    public String getFullName() {
        return name == null ? null : CodecUtils.getFullName(name);
    }

    /** The sender without the id of its process. */
    public String getSrcName() {
        return sender == null ? null : CodecUtils.getShortName(sender);
    }

    @Override
    public String toString() {
        return sender + "." + sendingMethod + " --> " + name + "." + method + "(" + (data == null ? "" : Arrays.deepToString(data)) + ")";
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
