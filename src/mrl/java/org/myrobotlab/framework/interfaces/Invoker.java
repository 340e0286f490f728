package org.myrobotlab.framework.interfaces;

/** Calls its own methods by name and publishes what they answer. */
public interface Invoker {
    /** Calls a method without arguments. */
    Object invoke(String method);

    /** Calls a method; an array as the only argument must be cast to Object. */
    Object invoke(String method, Object... params);
}
