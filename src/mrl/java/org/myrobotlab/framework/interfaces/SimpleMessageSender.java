package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Message;

/** Sends messages that are ready to go. */
public interface SimpleMessageSender {
    /** Puts a message on its way. */
    void send(Message msg);
}
