// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.input;

/** Speed set by the keys: each press in the same direction increases it. Window thread only. */
public final class KeyDrive {
    private static final double FIRST = 0.2;
    private static final double MORE = 0.1;
    /** Maximum speed, m/s: that of an iRobot Create (Open Interface, command Drive: 500 mm/s). */
    private static final double GREATEST = 0.5;

    private Key last = Key.STOP;
    private double speed;

    /**
     * Applies a key.
     * @return whether the key drives
     */
    public boolean press(Key key) {
        switch (key) {
            case FORWARD:
            case BACKWARD:
            case SPIN_LEFT:
            case SPIN_RIGHT:
                speed = key == last ? Math.min(GREATEST, speed + MORE) : FIRST;
                break;
            case STOP:
            case RESET:
                speed = 0;
                break;
            default:
                return false;
        }
        last = key;
        return true;
    }

    /** Returns the speed, m/s; negative for backward and for a spin to the right. */
    public double speed() {
        return last == Key.BACKWARD || last == Key.SPIN_RIGHT ? -speed : speed;
    }

    /** Returns the radius: 0 for a spin, otherwise infinite (straight). */
    public double radius() {
        return last == Key.SPIN_LEFT || last == Key.SPIN_RIGHT ? 0 : Double.POSITIVE_INFINITY;
    }

    /** Returns the command as text. */
    public String words() {
        switch (last) {
            case FORWARD:
                return String.format("forward, %.1f m/s", speed);
            case BACKWARD:
                return String.format("backward, %.1f m/s", speed);
            case SPIN_LEFT:
                return String.format("spin left, wheels %.1f m/s", speed);
            case SPIN_RIGHT:
                return String.format("spin right, wheels %.1f m/s", speed);
            default:
                return "stop";
        }
    }
}
