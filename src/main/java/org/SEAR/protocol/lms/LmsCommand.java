package org.SEAR.protocol.lms;

/** What an LMS2xx can be asked: the first byte of a telegram's payload. Source: SICK telegram listing, chapter 7. */
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

    /** First byte of what a device says by itself when it has started. */
    public static final int POWER_ON = 0x90;
    /** First byte of the answer to what is unknown, or not permitted in the present operating mode. */
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

    /** The command of that byte; null if there is none such. */
    public static LmsCommand of(int code) {
        for (LmsCommand command : values()) {
            if (command.code == code) {
                return command;
            }
        }
        return null;
    }

    /** The byte of a request. */
    public int getCode() {
        return code;
    }

    /** The byte of its answer. */
    public int getReply() {
        return reply;
    }

    /** A request's payload, to be continued with its data. */
    public LmsPayload request() {
        return new LmsPayload(code);
    }

    /** An answer's payload, to be continued with its data and the status byte. */
    public LmsPayload reply() {
        return new LmsPayload(reply);
    }
}
