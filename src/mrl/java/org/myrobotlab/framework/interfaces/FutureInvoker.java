// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

/** Calls its own methods after a delay. */
public interface FutureInvoker {
    /** Calls a method after a delay. */
    void invokeFuture(String method, long delayMs);

    /** Calls a method after a delay. */
    void invokeFuture(String method, long delayMs, Object... params);
}
