// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Message;

/** Sends messages. */
public interface SimpleMessageSender {
    /** Sends a message. */
    void send(Message msg);
}
