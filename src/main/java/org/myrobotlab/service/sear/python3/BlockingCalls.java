package org.myrobotlab.service.sear.python3;

import java.util.List;

/** Calls that wait, and that a program of Python 3 may break off. Public because Python calls it. Any thread. */
public final class BlockingCalls {
    private BlockingCalls() {
    }

    /**
     * Calls a method that answers nothing.
     *
     * @return whether it has come to its end; false if the thread was interrupted meanwhile, which is then forgotten
     * @throws Throwable what the method throws
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
