// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;
import org.SEAR.protocol.arduino.WireRole;

/**
 * An electric motor with a gear, which turns one or more wheels of its robot, or drives one of its joints. Its torque
 * decreases linearly with its speed: torque = stallTorque (power - speed / noLoadSpeed). Wheels share the torque, each
 * at its own speed. The SEAR service of the simulation commands the motor.
 */
@Described("an electric motor with a gear, which turns wheels of its robot or drives a joint: torque = stallTorque "
    + "(power - speed / noLoadSpeed); the wheels share the torque, each at its own speed")
public class Motor extends SearObject implements Wirable {
    private static final int MAX_WHEELS = 100;
    private static final double STALL_TORQUE = 0.5;
    private static final double NO_LOAD_SPEED = 20;
    private static final int COUNTS = 360;

    @Param(doc = "name of a driven wheel of the same robot", element = "wheel", text = TextRule.NAME,
        names = Wheel.class, needed = true, maxEntries = MAX_WHEELS)
    private List<String> wheelNames = new ArrayList<>();
    @Param(doc = "name of the hinge, slider or rope of the same robot that it drives, instead of wheels",
        text = TextRule.NAME, names = AxisJoint.class, needed = true)
    private String joint;
    @Param(doc = "torque of the motor's shaft at full power and standstill", unit = "N m", min = 1e-6, max = 1e6)
    private double stallTorque = STALL_TORQUE;
    @Param(doc = "speed of the motor's shaft at full power without load", unit = "rad/s", min = 0.001, max = 1e5)
    private double noLoadSpeed = NO_LOAD_SPEED;
    @Param(doc = "turns of the motor's shaft per turn of its wheels or hinge, radians per metre of a slider or rope",
        min = 0.001, max = 1e5)
    private double gearRatio = 1;
    @Param(doc = "encoder counts per turn of the motor's shaft; 0 for no encoder", max = 1e6)
    private int encoderCounts = COUNTS;

    /** For reading from a file. */
    protected Motor() {
    }

    /**
     * A small gear motor: stall torque 0.5 N m, no-load speed 20 rad/s, an encoder with 360 counts per turn.
     *
     * @param wheel a driven wheel that no other motor turns
     */
    public Motor(String name, Wheel wheel) {
        this(name, wheel, STALL_TORQUE, NO_LOAD_SPEED);
    }

    /**
     * With a gear ratio of 1.
     *
     * @param stallTorque N m
     * @param noLoadSpeed rad/s
     */
    public Motor(String name, Wheel wheel, double stallTorque, double noLoadSpeed) {
        this(name, wheel, stallTorque, noLoadSpeed, 1, COUNTS);
    }

    /**
     * With all parameters.
     *
     * @param stallTorque of the motor's shaft, N m
     * @param noLoadSpeed of the motor's shaft, rad/s
     * @param gearRatio turns of the motor's shaft per turn of the wheel
     * @param encoderCounts per turn of the motor's shaft, 0 for no encoder
     */
    public Motor(String name, Wheel wheel, double stallTorque, double noLoadSpeed, double gearRatio,
        int encoderCounts) {
        super(name);
        this.stallTorque = stallTorque;
        this.noLoadSpeed = noLoadSpeed;
        this.gearRatio = gearRatio;
        this.encoderCounts = encoderCounts;
        checkWheel(wheel);
        wheelNames.add(wheel.getName());
        created(Motor.class);
        wheel.setMover(this);
    }

    /**
     * Drives a joint: stall torque 0.5 N m, no-load speed 20 rad/s, an encoder with 360 counts per turn.
     *
     * @param joint a hinge, slider or rope of the same robot, without {@code setMotor}
     */
    public Motor(String name, AxisJoint joint) {
        this(name, joint, STALL_TORQUE, NO_LOAD_SPEED, 1, COUNTS);
    }

    /**
     * Drives a joint.
     *
     * @param joint a hinge, slider or rope of the same robot, without {@code setMotor}
     * @param stallTorque of the motor's shaft, N m
     * @param noLoadSpeed of the motor's shaft, rad/s
     * @param gearRatio turns of the motor's shaft per turn of a hinge, radians per metre of a slider or rope
     * @param encoderCounts per turn of the motor's shaft, 0 for no encoder
     */
    public Motor(String name, AxisJoint joint, double stallTorque, double noLoadSpeed, double gearRatio,
        int encoderCounts) {
        super(name);
        this.stallTorque = stallTorque;
        this.noLoadSpeed = noLoadSpeed;
        this.gearRatio = gearRatio;
        this.encoderCounts = encoderCounts;
        if (joint == null) {
            throw new IllegalArgumentException(label() + ": joint is missing (None), legal: a hinge, slider or rope of "
                + "the same robot, or a driven wheel (type 1)");
        }
        this.joint = joint.getName();
        created(Motor.class);
    }

    @Override
    boolean isRobotPart() {
        return true;
    }

    /** Returns the wires for power and direction, and for the encoder if the motor has one. */
    @Override
    public List<WireRole> getWireRoles() {
        return encoderCounts > 0 ? List.of(WireRole.PWM, WireRole.REVERSE, WireRole.DIRECTION, WireRole.ENCODER_A,
            WireRole.ENCODER_B) : List.of(WireRole.PWM, WireRole.REVERSE, WireRole.DIRECTION);
    }

    @Override
    protected void crossCheck(Faults faults) {
        if (wheelNames.isEmpty() && joint == null) {
            faults.add("wheel", "", "the name of a driven wheel of the same robot");
        } else if (!wheelNames.isEmpty() && joint != null) {
            faults.add("joint", joint, "none for a motor that turns wheels");
        }
    }

    private void checkWheel(Wheel wheel) {
        if (wheel == null) {
            throw new IllegalArgumentException(label() + ": wheel is missing (None), legal: a driven wheel (type 1)");
        }
        if (!wheel.isDriven()) {
            throw new IllegalArgumentException(label() + ": " + wheel.label() + " has type " + wheel.getType()
                + ", legal: a driven wheel (type 1)");
        }
        SearObject other = wheel.getMover();
        if (other != null && !other.getName().equals(getName())) {
            throw new IllegalArgumentException(label() + ": " + wheel.label() + " is turned by " + other.label()
                + ", legal: one motor per wheel; motor.addWheel(wheel) gives a motor several wheels");
        }
        if (robot() != null && wheel.robot() != null && robot() != wheel.robot()) {
            throw new IllegalArgumentException(label() + ": " + wheel.label() + " is a wheel of " + wheel.robot()
                .label() + ", legal: a wheel of " + robot().label());
        }
    }

    /**
     * Adds a wheel, which gets a share of the torque.
     *
     * @throws IllegalArgumentException if the wheel isn't driven, another motor turns it, or it belongs to another
     *     robot
     */
    public void addWheel(Wheel wheel) {
        checkChangeable();
        checkWheel(wheel);
        if (joint != null) {
            throw new IllegalArgumentException(label() + ": it drives the joint " + joint
                + ", legal: a motor of wheels");
        }
        if (wheelNames.contains(wheel.getName())) {
            throw new IllegalArgumentException(label() + ": " + wheel.label() + " is its wheel already, legal: "
                + "another wheel");
        }
        if (wheelNames.size() >= MAX_WHEELS) {
            throw new IllegalArgumentException(label() + ": wheel is " + wheel.label() + ", legal: at most "
                + MAX_WHEELS + " wheels");
        }
        wheelNames.add(wheel.getName());
        wheel.setMover(this);
        changed();
    }

    /** Returns the name of the joint that it drives; null for a motor of wheels. */
    public String getJoint() {
        return joint;
    }

    /** Returns the names of the motor's wheels; a view. */
    public List<String> getWheelNames() {
        return Collections.unmodifiableList(wheelNames);
    }

    public double getStallTorque() {
        return stallTorque;
    }

    public double getNoLoadSpeed() {
        return noLoadSpeed;
    }

    public double getGearRatio() {
        return gearRatio;
    }

    public int getEncoderCounts() {
        return encoderCounts;
    }

    /** @param newTorque of the motor's shaft, N m */
    public void setStallTorque(double newTorque) {
        stallTorque = checked("stallTorque", newTorque);
        changed();
    }

    /** @param newSpeed of the motor's shaft, rad/s */
    public void setNoLoadSpeed(double newSpeed) {
        noLoadSpeed = checked("noLoadSpeed", newSpeed);
        changed();
    }

    /** @param newRatio turns of the motor's shaft per turn of its wheels */
    public void setGearRatio(double newRatio) {
        gearRatio = checked("gearRatio", newRatio);
        changed();
    }

    /** @param newCounts per turn of the motor's shaft; 0 for no encoder */
    public void setEncoderCounts(int newCounts) {
        encoderCounts = checked("encoderCounts", newCounts);
        changed();
    }
}
