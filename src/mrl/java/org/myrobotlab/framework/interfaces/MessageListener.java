// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Message;

/** Gets each message that passes an inbox or outbox. */
public interface MessageListener extends NameProvider {
    /** Called with each message. */
    void onMessage(Message msg);
}
