// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import java.util.Arrays;

/**
 * A Create's script of up to 100 bytes of commands, and the wait commands 155 to 158 in or outside a script. The robot
 * ignores all input while it waits or runs a script. Only power-off ends an endless script ({@link
 * RoombaFirmware#reset}).
 */
final class CreateScript {
    private static final int MAX_BYTES = 100;
    private static final double WAIT_UNIT = 0.1;
    private static final int EVENT_PASSIVE = 22;

    private final RoombaFirmware roomba;
    private int[] bytes = new int[0];
    private int next = -1;
    private Opcode waiting;
    private int target;
    private double until;

    CreateScript(RoombaFirmware roomba) {
        this.roomba = roomba;
    }

    /**
     * Stores the script of command 152.
     *
     * @return whether it fits
     */
    boolean define(int[] arguments) {
        if (arguments[0] > MAX_BYTES) {
            return false;
        }
        bytes = Arrays.copyOfRange(arguments, 1, 1 + arguments[0]);
        return true;
    }

    /** Returns the script as command 154 sends it: length and bytes. */
    byte[] show() {
        byte[] out = new byte[bytes.length + 1];
        out[0] = (byte) bytes.length;
        for (int i = 0; i < bytes.length; i++) {
            out[i + 1] = (byte) bytes[i];
        }
        return out;
    }

    /** Starts the script at the next tick (command 153). */
    void play() {
        next = bytes.length == 0 ? -1 : 0;
    }

    void clear() {
        bytes = new int[0];
        next = -1;
        waiting = null;
    }

    /** Whether bytes from the line are ignored. */
    boolean isBusy() {
        return waiting != null || next >= 0;
    }

    /**
     * Starts a wait of commands 155 to 158.
     *
     * @return whether the arguments are legal
     */
    boolean await(Opcode wait, int[] arguments, double time) {
        if (wait == Opcode.WAIT_TIME) {
            until = time + arguments[0] * WAIT_UNIT;
        } else if (wait == Opcode.WAIT_EVENT) {
            target = (byte) arguments[0];
            if (target == 0 || Math.abs(target) > EVENT_PASSIVE) {
                return false;
            }
        } else {
            target = (short) (arguments[0] << 8 | arguments[1]);
            if (wait == Opcode.WAIT_DISTANCE) {
                roomba.getPackets().clearDistance();
            } else {
                roomba.getPackets().clearAngle();
            }
        }
        waiting = wait;
        return true;
    }

    /**
     * Continues the script up to its next wait; call it every 15 ms. Runs each byte of the script at most once per
     * call, so that a loop without a wait can't block.
     */
    void tick(double time) {
        if (waiting != null && !isHit(time)) {
            return;
        }
        waiting = null;
        while (next >= 0 && waiting == null) {
            if (next >= bytes.length) {
                next = -1;
                roomba.endOfScript();
                return;
            }
            roomba.feed(bytes[next++], time);
            if (next == 0) {
                return;
            }
        }
    }

    private boolean isHit(double time) {
        switch (waiting) {
            case WAIT_TIME:
                return time >= until;
            case WAIT_DISTANCE:
                return reached(roomba.getPackets().distanceSince());
            case WAIT_ANGLE:
                return reached(roomba.getPackets().angleSince());
            default:
                return roomba.isEvent(Math.abs(target)) == target > 0;
        }
    }

    private boolean reached(double value) {
        return target >= 0 ? value >= target : value <= target;
    }
}
