package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Message;

/** Carries out messages. */
public interface MessageInvoker {
    /** Calls the method that the message names. */
    Object invoke(Message msg);

    /** Calls a method of an object and publishes what it answers; blocking: the listeners are called before this returns. */
    Object invokeOn(boolean blockLocally, Object obj, String method, Object... params);
}
