// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

/** Requests to an LMS2xx: first byte of a telegram's payload. Source: SICK telegram listing, chapter 7. */
public enum LmsCommand {
    RESET(0x10, 0x91),
    MODE(0x20),
    SCAN(0x30),
    STATUS(0x31),
    ERRORS(0x32),
    MEAN(0x36),
    RANGE(0x37),
    TYPE(0x3A),
    VARIANT(0x3B),
    MEAN_RANGE(0x3F),
    PERMANENT_BAUD(0x66),
    GET_CONFIGURATION(0x74),
    SET_CONFIGURATION(0x77),
    PIXELS(0x7C);

    /** First payload byte of the power-on telegram. */
    public static final int POWER_ON = 0x90;
    /** First payload byte of the answer to an unknown request, or one not permitted in the present operating mode. */
    public static final int NOT_PERMITTED = 0x92;
    private static final int REPLY = 0x80;

    private final int code;
    private final int reply;

    LmsCommand(int code) {
        this(code, code + REPLY);
    }

    LmsCommand(int code, int reply) {
        this.code = code;
        this.reply = reply;
    }

    /** Finds a command by its byte; null if unknown. */
    public static LmsCommand of(int code) {
        for (LmsCommand command : values()) {
            if (command.code == code) {
                return command;
            }
        }
        return null;
    }

    /** Byte of the request. */
    public int getCode() {
        return code;
    }

    /** Byte of the answer. */
    public int getReply() {
        return reply;
    }

    /** Starts the payload of a request; its data follow. */
    public LmsPayload request() {
        return new LmsPayload(code);
    }

    /** Starts the payload of an answer; its data and the status byte follow. */
    public LmsPayload reply() {
        return new LmsPayload(reply);
    }
}
