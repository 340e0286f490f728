// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import static org.SEAR.devices.oi.Opcode.Needs.ACTIVE;
import static org.SEAR.devices.oi.Opcode.Needs.ANY;
import static org.SEAR.devices.oi.Opcode.Needs.ONLY_FULL;
import static org.SEAR.devices.oi.Opcode.Needs.ONLY_PASSIVE;
import static org.SEAR.devices.oi.Opcode.Needs.ONLY_SAFE;
import static org.SEAR.devices.oi.Opcode.Needs.STARTED;

/**
 * Commands with their number, number of argument bytes, and the modes that accept them. Source: the command tables of
 * the three specifications.
 */
public enum Opcode {
    RESET(7, Who.C2, 0, ANY),
    START(128, Who.ALL, 0, ANY),
    BAUD(129, Who.ALL, 1, STARTED),
    CONTROL(130, Who.ALL, 0, STARTED, ONLY_PASSIVE),
    SAFE(131, Who.ALL, 0, STARTED, ONLY_FULL),
    FULL(132, Who.ALL, 0, STARTED, ONLY_SAFE),
    POWER(133, Who.ALL, 0, STARTED, ACTIVE),
    SPOT(134, Who.ALL, 0, STARTED, ACTIVE),
    CLEAN(135, Who.ALL, 0, STARTED, ACTIVE),
    MAX(136, Who.R4 | Who.C2, 0, STARTED, ACTIVE),
    DEMO(136, Who.C1, 1, STARTED),
    DRIVE(137, Who.ALL, 4, ACTIVE),
    MOTORS(138, Who.ALL, 1, ACTIVE),
    LEDS(139, Who.ALL, 3, ACTIVE),
    SONG(140, Who.ALL, -2, STARTED),
    PLAY(141, Who.ALL, 1, ACTIVE),
    SENSORS(142, Who.ALL, 1, STARTED),
    DOCK(143, Who.ALL, 0, STARTED),
    PWM_MOTORS(144, Who.OI, 3, ACTIVE),
    DRIVE_DIRECT(145, Who.OI, 4, ACTIVE),
    DRIVE_PWM(146, Who.C2, 4, ACTIVE),
    OUTPUTS(147, Who.C1, 1, ACTIVE),
    STREAM(148, Who.OI, -1, STARTED),
    QUERY_LIST(149, Who.OI, -1, STARTED),
    PAUSE_STREAM(150, Who.OI, 1, STARTED),
    SEND_IR(151, Who.C1, 1, ACTIVE),
    SCRIPT(152, Who.C1, -1, STARTED),
    PLAY_SCRIPT(153, Who.C1, 0, STARTED),
    SHOW_SCRIPT(154, Who.C1, 0, STARTED),
    WAIT_TIME(155, Who.C1, 1, STARTED),
    WAIT_DISTANCE(156, Who.C1, 2, STARTED),
    WAIT_ANGLE(157, Who.C1, 2, STARTED),
    WAIT_EVENT(158, Who.C1, 1, STARTED),
    SCHEDULING_LEDS(162, Who.C2, 2, ACTIVE),
    DIGIT_LEDS(163, Who.C2, 4, ACTIVE),
    DIGIT_TEXT(164, Who.C2, 4, ACTIVE),
    BUTTONS(165, Who.C2, 1, STARTED),
    SCHEDULE(167, Who.C2, 15, STARTED),
    SET_TIME(168, Who.C2, 3, STARTED),
    STOP(173, Who.C2, 0, STARTED);

    /** Modes that accept a command. */
    enum Needs {
        ANY, STARTED, ACTIVE, ONLY_PASSIVE, ONLY_SAFE, ONLY_FULL;

        boolean allows(OiMode mode) {
            switch (this) {
                case ANY:
                    return true;
                case STARTED:
                    return mode != OiMode.OFF;
                case ACTIVE:
                    return mode.isActive();
                case ONLY_PASSIVE:
                    return mode == OiMode.PASSIVE;
                case ONLY_SAFE:
                    return mode == OiMode.SAFE;
                default:
                    return mode == OiMode.FULL;
            }
        }
    }

    /** Bit masks of models. */
    private static final class Who {
        static final int R4 = 1;
        static final int C1 = 2;
        static final int C2 = 4;
        static final int OI = C1 | C2;
        static final int ALL = R4 | OI;
    }

    private static final int BYTE = 0xFF;

    private final int code;
    private final int models;
    private final int arguments;
    private final Needs needs;
    private final Needs ladderNeeds;

    Opcode(int code, int models, int arguments, Needs needs) {
        this(code, models, arguments, needs, needs);
    }

    Opcode(int code, int models, int arguments, Needs needs, Needs ladderNeeds) {
        this.code = code;
        this.models = models;
        this.arguments = arguments;
        this.needs = needs;
        this.ladderNeeds = ladderNeeds;
    }

    /** Finds a model's command by number; null if the model has no such command. */
    public static Opcode of(int code, OiModel model) {
        for (Opcode opcode : values()) {
            if (opcode.code == code && (opcode.models & 1 << model.ordinal()) != 0) {
                return opcode;
            }
        }
        return null;
    }

    public int getCode() {
        return code;
    }

    /** Whether a model accepts the command in a mode. */
    public boolean isAllowed(OiModel model, OiMode mode) {
        return (model.isLadder() ? ladderNeeds : needs).allows(mode);
    }

    /** Number of argument bytes, given the bytes received so far; -1 while still unknown. */
    public int argumentCount(int[] come, int count) {
        if (arguments >= 0) {
            return arguments;
        }
        int counter = -arguments;
        if (count < counter) {
            return -1;
        }
        int times = this == SONG ? 2 : 1;
        return counter + times * (come[counter - 1] & BYTE);
    }
}
