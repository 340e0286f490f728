package org.myrobotlab.embedded;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Runtime;

/**
 * Waits of scripts and services while a service runs a simulation in lock-step, where time passes only when it is asked to: that service is asked, by
 * the names of its methods, as messages ask it ({@code isLockStep}, {@code simSleep}). Any thread.
 */
public final class Waiting {
    private static final String LOCK_STEP = "isLockStep";
    private static final String SLEEP = "simSleep";

    private Waiting() {
    }

    /**
     * Lets so much simulated time pass.
     *
     * @param seconds 0 or more
     * @return whether there was a simulation to do so; if not, nobody has waited
     */
    public static boolean inSimulation(double seconds) {
        if (!Runtime.exists()) {
            return false;
        }
        for (ServiceInterface service : Runtime.getServices()) {
            if (Boolean.TRUE.equals(call(service, LOCK_STEP))) {
                call(service, SLEEP, seconds);
                return true;
            }
        }
        return false;
    }

    private static Object call(ServiceInterface service, String name, Object... values) {
        Method method = Methods.find(service.getClass(), name, values);
        if (method == null) {
            return null;
        }
        try {
            return Methods.call(service, method, values);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof RuntimeException) {
                throw (RuntimeException) e.getCause();
            }
            throw new IllegalStateException(e.getCause());
        }
    }
}
