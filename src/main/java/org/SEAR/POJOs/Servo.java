// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.TextRule;
import org.SEAR.protocol.arduino.WireRole;

/**
 * A servo motor, which turns the parts mounted on it about the servo's own y axis: a sensor, a shape, another servo.
 * The pose of a mounted part on the robot is that with the servo at 0 degrees.
 */
@Described("a servo motor, which turns the parts mounted on it about its own y axis; their poses are those with the "
    + "servo at 0 degrees")
public class Servo extends SearObject implements Wirable {
    /** Parts that a servo can turn, in words. */
    public static final String TURNABLE = MovedParts.LEGAL;
    private static final double HALF_RANGE = 90;
    private static final double SPEED = 400;
    /** Stall torque of a 9 g servo at 4.8 V (Tower Pro SG90: 1.8 kgf cm), N m. */
    private static final double STALL_TORQUE = 0.18;

    @Param(doc = "smallest angle", unit = "deg", min = -360, max = 360)
    private double minAngle = -HALF_RANGE;
    @Param(doc = "greatest angle, + counter-clockwise from above", unit = "deg", min = -360, max = 360)
    private double maxAngle = HALF_RANGE;
    @Param(doc = "speed without load", unit = "deg/s", min = 0.1, max = 36000)
    private double speed = SPEED;
    @Param(doc = "stall torque; weight on the servo slows it: torque = stallTorque (power - speed / no-load speed)",
        unit = "N m", min = 1e-6, max = 1e6)
    private double stallTorque = STALL_TORQUE;
    @Param(doc = "whether only the motor turns the parts, not their load, as with a worm gear")
    private Boolean selfLocking;
    @Param(doc = "play of the gear: angle that the motor turns before the parts follow", unit = "deg", max = 90)
    private double play;
    @Param(doc = "dead time of commands", unit = "s", max = 1)
    private double delay;
    @Param(doc = "name of a component of the same robot that it turns: " + TURNABLE,
        element = "part", text = TextRule.NAME, names = SearObject.class, maxEntries = MovedParts.MOST)
    private List<String> partNames = new ArrayList<>();

    /** For reading from a file. */
    protected Servo() {
    }

    /** At the origin of the robot, its axis vertical: -90 to 90 degrees, 400 degrees a second, 0.18 N m. */
    public Servo(String name) {
        this(name, 0, 0, 0, 0, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres, its axis vertical. */
    public Servo(String name, double x, double y, double z) {
        this(name, x, y, z, 0, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres; (rx, ry, rz), degrees, turn its axis. */
    public Servo(String name, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        pose(x, y, z, rx, ry, rz);
        created(Servo.class);
    }

    @Override
    boolean isServo() {
        return true;
    }

    @Override
    boolean isRobotPart() {
        return true;
    }

    @Override
    public List<WireRole> getWireRoles() {
        return List.of(WireRole.SERVO);
    }

    @Override
    protected void crossCheck(Faults faults) {
        if (minAngle >= maxAngle) {
            faults.add("minAngle", minAngle, "less than maxAngle, which is " + Parameter.format(maxAngle) + " deg");
        }
    }

    /**
     * Mounts a component of the same robot.
     *
     * @param part a shape, a light, another servo, or a sensor except motion sensors and GPS
     * @throws IllegalArgumentException if the part can't be turned, another servo turns it, or it is on another robot
     */
    public void mount(SearObject part) {
        checkChangeable();
        MovedParts.add(this, partNames, part);
        changed();
    }

    /** Returns whether a servo can turn a kind of component: not a wheel, nor a sensor of motion or position. */
    public static boolean canTurn(SearObject part) {
        return MovedParts.canMove(part);
    }

    /** Returns the names of the mounted components; a view. */
    public List<String> getPartNames() {
        return Collections.unmodifiableList(partNames);
    }

    public double getMinAngle() {
        return minAngle;
    }

    public double getMaxAngle() {
        return maxAngle;
    }

    public double getSpeed() {
        return speed;
    }

    /**
     * Sets the range of angles.
     *
     * @param smallest angle, degrees
     * @param greatest angle, degrees, + counter-clockwise seen from above
     */
    public void setRange(double smallest, double greatest) {
        double checkedMin = checked("minAngle", smallest);
        double checkedMax = checked("maxAngle", greatest);
        if (checkedMin >= checkedMax) {
            throw new IllegalArgumentException(label() + ": minAngle is " + Parameter.format(smallest)
                + ", legal: less than maxAngle, which is "
                + Parameter.format(greatest) + " deg");
        }
        minAngle = checkedMin;
        maxAngle = checkedMax;
        changed();
    }

    /** @param newSpeed degrees a second, without load */
    public void setSpeed(double newSpeed) {
        speed = checked("speed", newSpeed);
        changed();
    }

    public double getStallTorque() {
        return stallTorque;
    }

    /** @param newTorque N m */
    public void setStallTorque(double newTorque) {
        stallTorque = checked("stallTorque", newTorque);
        changed();
    }

    public boolean isSelfLocking() {
        return selfLocking != null && selfLocking;
    }

    /** @param on whether only the motor turns the parts, not their load, as with a worm gear or a brake */
    public void setSelfLocking(boolean on) {
        selfLocking = checked("selfLocking", on);
        changed();
    }

    public double getPlay() {
        return play;
    }

    /** @param degrees that the motor turns before the parts follow, 0 to 90; small plastic gears have about 1 */
    public void setPlay(double degrees) {
        play = checked("play", degrees);
        changed();
    }

    public double getDelay() {
        return delay;
    }

    /**
     * @param seconds between a command and its start, 0 to 1, rounded to 1/60 s; hobby servos take a pulse every 0.02 s
     */
    public void setDelay(double seconds) {
        delay = checked("delay", seconds);
        changed();
    }
}
