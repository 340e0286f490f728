// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

/** Runs scripts. */
public interface Processor {
    /**
     * Runs code.
     *
     * @return whether it succeeded
     */
    boolean exec(String code);
}
