// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

/**
 * Last settings of lights, brush and vacuum motors, for display. The simulated robot has no such hardware, and no
 * outputs or digit displays.
 */
public final class Lights {
    private int bits;
    private int colour;
    private int intensity;
    private int motors;

    /**
     * Runs commands 138, 139, 144, 147 and 162 to 164.
     *
     * @return whether the command is one of these
     */
    boolean set(Opcode opcode, int[] a) {
        switch (opcode) {
            case LEDS:
                bits = a[0];
                colour = a[1];
                intensity = a[2];
                return true;
            case MOTORS:
                motors = a[0];
                return true;
            case PWM_MOTORS:
                motors = (a[0] != 0 ? 4 : 0) | (a[1] != 0 ? 1 : 0) | (a[2] != 0 ? 2 : 0);
                return true;
            case OUTPUTS:
            case DIGIT_TEXT:
            case SCHEDULING_LEDS:
            case DIGIT_LEDS:
                return true;
            default:
                return false;
        }
    }

    void setMotors(int newMotors) {
        motors = newMotors;
    }

    /** First byte of command 139. */
    public int getBits() {
        return bits;
    }

    String describe() {
        return "lights " + Integer.toHexString(bits) + "h, power light " + colour + "/" + intensity
            + (motors == 0 ? "" : ", motors " + motors);
    }
}
