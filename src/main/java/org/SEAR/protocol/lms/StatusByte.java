// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

/** The last byte of each reply. Source: SICK telegram listing, chapter 8. */
public final class StatusByte {
    /** No error; LMS type 6. */
    public static final int OK = 0x10;
    private static final int SEVERITY = 7;
    private static final int ERROR = 3;
    private static final int POLLUTED = 0x80;

    private StatusByte() {
    }

    /** Whether the window is dirty. */
    public static boolean isPolluted(int status) {
        return (status & POLLUTED) != 0;
    }

    /** Whether the device reports an error or worse; infos and warnings don't count. */
    public static boolean isError(int status) {
        return (status & SEVERITY) >= ERROR;
    }
}
