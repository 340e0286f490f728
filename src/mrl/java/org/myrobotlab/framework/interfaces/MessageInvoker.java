// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Message;

/** Executes messages. */
public interface MessageInvoker {
    /** Calls the method that the message names. */
    Object invoke(Message msg);

    /**
     * Calls a method of an object and publishes the result.
     *
     * @param blockLocally whether to call the listeners before this returns
     */
    Object invokeOn(boolean blockLocally, Object obj, String method, Object... params);
}
