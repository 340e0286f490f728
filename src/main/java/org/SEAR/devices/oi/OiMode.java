// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

/** Mode of the Open Interface; the ordinal is packet 35: 0 off, 1 passive, 2 safe, 3 full. */
public enum OiMode {
    OFF, PASSIVE, SAFE, FULL;

    /** Whether motors and lights accept commands. */
    public boolean isActive() {
        return this == SAFE || this == FULL;
    }
}
