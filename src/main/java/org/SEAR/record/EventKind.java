// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

/** The events of a record: each is one byte with this number, followed by its data. docs/records.md has the table. */
final class EventKind {
    static final int STEP = 1;
    static final int FRAME = 2;
    static final int HEARD = 3;
    static final int SAID = 4;
    static final int BAUD = 5;
    static final int LINE_CLOSED = 6;
    static final int DRIVE = 7;
    static final int POWER = 8;
    static final int RESET = 9;
    static final int END = 10;
    static final int OPENED = 11;
    static final int LIGHT = 12;
    static final int ORDER = 13;
    static final int MOVED = 14;
    static final int DEVICES_SERVICED = 15;
    static final int BODY_ORDER = 16;
    static final int PICTURE = 17;
    /** Highest event number. */
    static final int MOST = PICTURE;

    private EventKind() {
    }
}
