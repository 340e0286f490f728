// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

/** Has a name. */
public interface NameProvider {
    /** Short name, without the process id. */
    String getName();
}
