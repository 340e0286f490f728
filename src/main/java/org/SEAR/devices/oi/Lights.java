package org.SEAR.devices.oi;

/** Lights, brush and vacuum motors, outputs and digits as they were last set: state for those who look; the simulated robot has none of them. */
public final class Lights {
    private int bits;
    private int colour;
    private int intensity;
    private int motors;
    private int outputs;
    private final char[] digits = {' ', ' ', ' ', ' '};

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
                outputs = a[0];
                return true;
            case DIGIT_TEXT:
                for (int i = 0; i < digits.length; i++) {
                    digits[i] = a[i] >= ' ' && a[i] <= '~' ? (char) a[i] : ' ';
                }
                return true;
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

    /** Colour of the power light, 0 green to 255 red. */
    public int getColour() {
        return colour;
    }

    /** Brightness of the power light, 0 to 255. */
    public int getIntensity() {
        return intensity;
    }

    /** Bits of command 138: what of brushes and vacuum runs. */
    public int getMotors() {
        return motors;
    }

    /** Bits of command 147. */
    public int getOutputs() {
        return outputs;
    }

    /** Text of command 164. */
    public String getDigits() {
        return new String(digits);
    }

    String describe() {
        return "lights " + Integer.toHexString(bits) + "h, power light " + colour + "/" + intensity + (motors == 0 ? "" : ", motors " + motors);
    }
}
