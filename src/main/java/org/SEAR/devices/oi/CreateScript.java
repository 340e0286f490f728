package org.SEAR.devices.oi;

import java.util.Arrays;

/**
 * A Create's script: up to 100 bytes of commands that it carries out by itself, and the waiting of commands 155 to 158, in a script or outside. While
 * it waits the robot reacts to no input; so a script without end is ended by power off only ({@link RoombaFirmware#reset}).
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
     * Command 152.
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

    /** The script as command 154 shows it: length and bytes. */
    byte[] show() {
        byte[] out = new byte[bytes.length + 1];
        out[0] = (byte) bytes.length;
        for (int i = 0; i < bytes.length; i++) {
            out[i + 1] = (byte) bytes[i];
        }
        return out;
    }

    /** Command 153: from the beginning, with the next tick. */
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
     * Commands 155 to 158.
     *
     * @return whether it is possible
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

    /** Every 15 ms: goes on with the script up to its next wait. At most one run through the script, so one without a wait holds nothing up. */
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
