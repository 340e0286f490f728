// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear;

import com.sun.jna.Library;
import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;

/**
 * Signals that end a Python program with Java in its process. The package {@code sear} leaves them to Python, because
 * Java's own handlers would end Java below the running Python, which crashes. Uses {@code sun.misc.Signal} by
 * reflection, because the compiler warns of this class, and the warning can't be disabled.
 */
final class EndSignals {
    private static final String[] NAMES = {"INT", "TERM", "HUP"};
    /** Size of the system's struct sigaction, or more; its first field is the handler, 0 for the default action. */
    private static final int SIGACTION_SIZE = 256;

    private EndSignals() {
    }

    /** Functions of the C library. */
    interface C extends Library {
        int sigaction(int signal, Pointer action, Pointer old);

        int raise(int signal);
    }

    /**
     * Lets a task precede the default action of these signals. Changes no signal for which the program has set another
     * action, and none that is ignored.
     *
     * @param task must end soon
     * @throws ReflectiveOperationException if this Java has no {@code sun.misc.Signal}
     * @throws LinkageError if there is no JNA
     */
    static void precede(Runnable task) throws ReflectiveOperationException {
        C c = Native.load("c", C.class);
        Class<?> signals = Class.forName("sun.misc.Signal");
        Class<?> handlers = Class.forName("sun.misc.SignalHandler");
        Method handle = signals.getMethod("handle", signals, handlers);
        Method getNumber = signals.getMethod("getNumber");
        Object defaultAction = handlers.getField("SIG_DFL").get(null);
        Class<?>[] types = {handlers};
        Object handler = Proxy.newProxyInstance(EndSignals.class.getClassLoader(), types, (proxy, method, given) -> {
            task.run();
            handle.invoke(null, given[0], defaultAction);
            c.raise((Integer) getNumber.invoke(given[0]));
            return null;
        });
        for (String name : NAMES) {
            Object signal = signals.getConstructor(String.class).newInstance(name);
            Memory old = new Memory(SIGACTION_SIZE);
            if (c.sigaction((Integer) getNumber.invoke(signal), null, old) == 0 && old.getPointer(0) == null) {
                handle.invoke(null, signal, handler);
            }
        }
    }
}
