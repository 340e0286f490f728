package org.SEAR.devices.lms;

import org.SEAR.protocol.lms.Identity;
import org.SEAR.protocol.lms.Variant;

/** What one LMS2xx is set to when its power comes on. Immutable. */
public final class PowerOnSettings {
    /** Variant until another is chosen. */
    public final Variant variant;
    /** Bits a second. */
    public final int baud;
    /** Whether the baud telegrams of MyRobotLab's old driver are obeyed although their checksum is wrong. */
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
