package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Message;

/** Gets each message that passes a box. */
public interface MessageListener extends NameProvider {
    /** Called with each message. */
    void onMessage(Message msg);
}
