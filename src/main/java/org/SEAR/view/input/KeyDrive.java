package org.SEAR.view.input;

/** The speed that the keys have asked for: each press in the same direction makes it faster. Window thread only. */
public final class KeyDrive {
    private static final double FIRST = 0.2;
    private static final double MORE = 0.1;
    /** m/s: the greatest speed of an iRobot Create (Open Interface, command Drive: 500 mm/s). */
    private static final double GREATEST = 0.5;

    private Key last = Key.STOP;
    private double speed;

    /**
     * Obeys a key.
     *
     * @return whether it is one that drives
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

    /** m/s, negative for backward and for a spin to the right. */
    public double speed() {
        return last == Key.BACKWARD || last == Key.SPIN_RIGHT ? -speed : speed;
    }

    /** 0 for a spin, else infinite: straight. */
    public double radius() {
        return last == Key.SPIN_LEFT || last == Key.SPIN_RIGHT ? 0 : Double.POSITIVE_INFINITY;
    }

    /** What the robot was told, in words. */
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
