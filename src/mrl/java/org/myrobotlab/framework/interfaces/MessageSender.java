// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.TimeoutException;

/** Sends messages to services by name. */
public interface MessageSender extends NameProvider, SimpleMessageSender {
    /** Makes a service call its method. */
    void send(String name, String method);

    /** Makes a service call its method with these arguments. */
    void send(String name, String method, Object... data);

    /** Sends and waits for the answer. */
    Object sendBlocking(String name, String method) throws InterruptedException, TimeoutException;

    /** Sends and waits for the answer. */
    Object sendBlocking(String name, String method, Object... data) throws InterruptedException, TimeoutException;

    /**
     * Sends and waits for the answer.
     *
     * @param timeout milliseconds; null waits without limit
     */
    Object sendBlocking(String name, Integer timeout, String method, Object... data)
        throws InterruptedException, TimeoutException;

    /**
     * Sends and waits for the answer.
     *
     * @param timeout milliseconds; null waits without limit
     */
    Object sendBlocking(Message msg, Integer timeout) throws InterruptedException, TimeoutException;
}
