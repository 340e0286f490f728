package org.myrobotlab.framework.interfaces;

/** Publishes and waits until the local listeners were called. */
public interface Broadcaster {
    /** As invoke, but the listeners are called before this returns. */
    Object broadcast(String method);

    /** As invoke, but the listeners are called before this returns. */
    Object broadcast(String method, Object... params);
}
