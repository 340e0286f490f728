// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

/** Calls its own methods by name and publishes the results. */
public interface Invoker {
    /** Calls a method without arguments. */
    Object invoke(String method);

    /** Calls a method; cast an array as the only argument to Object. */
    Object invoke(String method, Object... params);
}
