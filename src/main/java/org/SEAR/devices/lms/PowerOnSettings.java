// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import org.SEAR.protocol.lms.Identity;
import org.SEAR.protocol.lms.Variant;

/** Settings of an LMS2xx at power-on. Immutable. */
public final class PowerOnSettings {
    /** Initial variant. */
    public final Variant variant;
    /** Baud rate, bits per second. */
    public final int baud;
    /** Whether it accepts the baud telegrams of MyRobotLab's old driver in spite of their wrong checksum. */
    public final boolean lenient;
    /** Type, serial number, address. */
    public final Identity identity;

    public PowerOnSettings(Variant variant, int baud, boolean lenient, Identity identity) {
        this.variant = variant;
        this.baud = baud;
        this.lenient = lenient;
        this.identity = identity;
    }
}
