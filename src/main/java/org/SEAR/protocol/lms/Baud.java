// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

/** Baud rates of the LMS200. Source: SICK telegram listing, tables 6-2 and 7-33. */
public enum Baud {
    B9600(0x42, 9600, 0x8067),
    B19200(0x41, 19200, 0x8033),
    B38400(0x40, 38400, 0x8019),
    B500000(0x48, 500000, 0x8001);

    private final int mode;
    private final int rate;
    private final int status;

    Baud(int mode, int rate, int status) {
        this.mode = mode;
        this.rate = rate;
        this.status = status;
    }

    /** Rate that telegram {@code 20 mode} selects; null for other modes. */
    public static Baud ofMode(int mode) {
        for (Baud baud : values()) {
            if (baud.mode == mode) {
                return baud;
            }
        }
        return null;
    }

    /** Finds a rate in bits per second; null if an LMS200 does not have it. */
    public static Baud ofRate(int rate) {
        for (Baud baud : values()) {
            if (baud.rate == rate) {
                return baud;
            }
        }
        return null;
    }

    /** Rate to try after another one, cyclically; the slowest after a rate that an LMS200 does not have. */
    public static Baud after(int rate) {
        Baud baud = ofRate(rate);
        return baud == null ? values()[0] : values()[(baud.ordinal() + 1) % values().length];
    }

    /** Second byte of the telegram {@code 20 mode} that selects this rate. */
    public int getMode() {
        return mode;
    }

    /** Bits per second. */
    public int getRate() {
        return rate;
    }

    /** Word at offset 116 of the status telegram. */
    public int getStatusWord() {
        return status;
    }
}
