package org.SEAR.devices.oi;

/** Packet 35: 0 off, 1 passive, 2 safe, 3 full. */
public enum OiMode {
    OFF, PASSIVE, SAFE, FULL;

    /** Whether motors and lights obey. */
    public boolean isActive() {
        return this == SAFE || this == FULL;
    }
}
