// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

/** Has a type. */
public interface TypeProvider {
    /** Type without its package. */
    String getSimpleName();
}
