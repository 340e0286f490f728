// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

/** Publishes on the caller's thread. */
public interface Broadcaster {
    /** Same as invoke, but calls the listeners before it returns. */
    Object broadcast(String method);

    /** Same as invoke, but calls the listeners before it returns. */
    Object broadcast(String method, Object... params);
}
