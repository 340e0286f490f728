// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Message;

/** Inbox and outbox of a service. */
public interface ServiceQueue {
    /** Puts a message into the inbox. */
    void in(Message msg);

    /** Puts a message into the outbox. */
    void out(Message msg);

    Object invoke(String method);

    Object invoke(String method, Object... params);
}
