package org.SEAR.devices.oi;

/** Lights, brush and vacuum motors as they were last set, for those who look. The simulated robot has none of them, and no outputs or digits. */
public final class Lights {
    private int bits;
    private int colour;
    private int intensity;
    private int motors;

    /**
     * Commands 138, 139, 144, 147, 162 to 164.
     *
     * @return whether it was one of these
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
        return "lights " + Integer.toHexString(bits) + "h, power light " + colour + "/" + intensity + (motors == 0 ? "" : ", motors " + motors);
    }
}
