// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.cola;

/** Error codes of a scanner, sent as {@code sFA code}. Source: SICK's telegram listing and {@code sick_scan_xd}. */
public enum ColaError {
    ACCESS_DENIED(0x1),
    UNKNOWN_METHOD(0x2),
    UNKNOWN_VARIABLE(0x3),
    CONDITION_FAILED(0x4),
    INVALID_DATA(0x5),
    TOO_FEW_VALUES(0x8),
    WRITE_ACCESS_DENIED(0xA),
    UNKNOWN_COMMAND(0xC),
    UNKNOWN_EVENT(0xF),
    VALUE_OVERFLOW(0x10),
    INVALID_CHARACTER(0x11);

    private final int code;

    ColaError(int code) {
        this.code = code;
    }

    /** Number after {@code sFA}. */
    public int getCode() {
        return code;
    }

    /** Telegram of the error: text {@code sFA 3}, or {@code sFA} and two bytes. */
    public byte[] telegram(ColaDialect dialect) {
        return new ColaPayload(dialect).verb("sFA").u2(code).toTelegram();
    }
}
