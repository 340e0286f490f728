// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.python3;

import java.util.List;

/** Blocking calls that a Python 3 program may cancel. Public because Python calls it. Any thread. */
public final class BlockingCalls {
    private BlockingCalls() {
    }

    /**
     * Calls a method without a result.
     *
     * @return whether the call completed; false if the thread was interrupted; clears the interrupt then
     * @throws Throwable the method's exception
     */
    public static boolean call(Object of, String name, List<?> arguments) throws Throwable {
        try {
            GatewayCalls.call(of, name, arguments);
            return true;
        } catch (IllegalStateException e) {
            if (e.getCause() instanceof InterruptedException) {
                Thread.interrupted();
                return false;
            }
            throw e;
        }
    }
}
