// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.io.IOException;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;

/**
 * A wheel of a robot; its axle lies along x, its pose is in the body frame. A wheel that was added to a robot ({@link
 * SEARrobot#addWheel}) is stored in the robot's XML file. Reading the project reports a wheel that was never added.
 */
@Described("a wheel of a robot, its axle along x; the robot's file contains it")
public class Wheel extends Shape {
    /** Type of a wheel that rolls freely in every direction. */
    public static final int IDLER = 0;
    /** Type of a wheel with a motor. */
    public static final int DRIVEN = 1;
    /** Type of a wheel that rolls freely in its own plane and grips sideways. */
    public static final int FREE = 2;
    /** Smallest distance from the robot's turning line at which a wheel can steer, metres. */
    private static final double MIN_LENGTH = 1e-3;

    @Param(doc = "radius", unit = "m", min = SMALL, max = 100, required = true, initial = "0.05")
    private double radius;
    @Param(doc = "size along the axle", unit = "m", min = SMALL, max = 100, required = true, initial = "0.03")
    private double width;
    @Param(doc = "0 idler, rolls freely in every direction; 1 driven; 2 rolls freely in its own plane",
        values = {"0", "1", "2"}, words = {"idler", "driven", "free"}, max = 2)
    private int type = DRIVEN;
    @Param(doc = "greatest steering angle of a wheel in the middle; the inner one of a pair turns further, the outer "
        + "one less; default not steered", unit = "deg", min = 0.1, max = 80)
    private Double steering;
    @Param(doc = "name of the servo that steers it, instead of a greatest angle", text = TextRule.NAME,
        names = SearObject.class)
    private String steeringServo;
    @Param(doc = "distance of a caster behind its vertical axis, which is at its x and z; 0 for no caster", unit = "m",
        max = 10)
    private double trail;
    @Param(doc = "angle from its rolling direction to the axis of the roller on the ground, from above, + to the left: "
        + "0 omni wheel, 45 or -45 mecanum wheel; default no rollers", unit = "deg", min = -80, max = 80)
    private Double rollers;

    /** For reading from a file. */
    protected Wheel() {
    }

    /** A driven wheel. */
    public Wheel(String name, double radius, double width) {
        this(name, radius, width, DRIVEN);
    }

    /** @param type 1 driven; 0 idler, rolls freely in every direction; 2 rolls freely in its own plane */
    public Wheel(String name, double radius, double width, int type) {
        this(name, radius, width, type, 0, 0, 0);
    }

    /** With its centre at (x, y, z) of the body frame, metres. */
    public Wheel(String name, double radius, double width, int type, double x, double y, double z) {
        this(name, radius, width, type, null, x, y, z);
    }

    /**
     * With all parameters.
     *
     * @param image path below assets; null for the default picture
     */
    public Wheel(String name, double radius, double width, int type, String image, double x, double y, double z) {
        super(name, 0);
        this.radius = radius;
        this.width = width;
        this.type = type;
        wrap(image);
        pose(x, y, z, 0, 0, 0);
        created(Wheel.class);
    }

    @Override
    protected void crossCheck(Faults faults) {
        toFaultsOfLaunch(faults, "0 for a wheel, which moves with its robot");
        if (type == IDLER && (steering != null || steeringServo != null)) {
            faults.add(steering == null ? "steeringServo" : "steering", steering == null ? steeringServo : steering,
                whatSteers());
        }
        if (steering != null && steeringServo != null) {
            faults.add("steering", steering, "none where a servo steers the wheel");
        }
        if (trail > 0 && type != IDLER) {
            faults.add("trail", trail, whatTrails());
        }
        if (rollers != null && type == IDLER) {
            faults.add("rollers", rollers, whatSteers());
        }
        if (rollers != null && isSteered()) {
            faults.add("rollers", rollers, "none for a wheel that is steered");
        }
    }

    private String whatSteers() {
        return "none for an idler (type 0), which rolls in every direction; use a wheel of type 1 or 2";
    }

    private String whatTrails() {
        return "0 for a wheel of type " + type + "; an idler (type 0) can be a caster";
    }

    @Override
    boolean isKept() throws IOException {
        return robot() == null ? super.isKept() : robot().isKept();
    }

    @Override
    void save() throws IOException {
        if (robot() == null) {
            super.save();
        } else {
            robot().save();
        }
    }

    @Override
    boolean isRobotPart() {
        return true;
    }

    @Override
    String whyFixed(String parameter) {
        if (Shape.isLaunching(parameter)) {
            return "a wheel belongs to a robot and moves with it";
        }
        return PlacedObject.isPlacing(parameter) ? "a wheel belongs to a robot; place the robot" : null;
    }

    @Override
    String whyNoComponent() {
        return " is a wheel, legal: robot.addWheel(wheel)";
    }

    public double getRadius() {
        return radius;
    }

    public double getWidth() {
        return width;
    }

    public int getType() {
        return type;
    }

    /** Adds {@code driven}: whether it can be driven. */
    @Override
    protected void addDrawingProperties(Map<String, Object> properties) {
        super.addDrawingProperties(properties);
        properties.put("driven", isDriven());
    }

    public boolean isDriven() {
        return type == DRIVEN;
    }

    /** Returns whether the wheel is steered, directly or by a servo. */
    public boolean isSteered() {
        return steering != null || steeringServo != null;
    }

    public Double getSteering() {
        return steering;
    }

    public String getSteeringServo() {
        return steeringServo;
    }

    public double getTrail() {
        return trail;
    }

    public Double getRollers() {
        return rollers;
    }

    /**
     * Makes the wheel steerable.
     *
     * @param greatest steering angle of a wheel in the middle, degrees
     * @throws IllegalArgumentException if the wheel is an idler, or has rollers
     */
    public void setSteering(double greatest) {
        Double before = steering;
        String servo = steeringServo;
        steering = checked("steering", greatest);
        steeringServo = null;
        changedIfLegal(() -> {
            steering = before;
            steeringServo = servo;
        });
    }

    /**
     * Lets a servo steer the wheel. The servo's angle is that of a wheel in the middle.
     *
     * @param servo of the same robot; the same for all its steered wheels
     * @throws IllegalArgumentException if the object is no servo, or the wheel is an idler or has rollers
     */
    public void setSteering(SearObject servo) {
        if (servo == null || !servo.isServo()) {
            throw new IllegalArgumentException(
                label() + ": steering is " + (servo == null ? "missing (None)" : servo.label())
                + ", legal: a Servo, or the greatest angle");
        }
        Double before = steering;
        String other = steeringServo;
        steeringServo = checked("steeringServo", servo.getName());
        steering = null;
        changedIfLegal(() -> {
            steering = before;
            steeringServo = other;
        });
    }

    /**
     * Makes an idler a caster, which turns freely about a vertical axis.
     *
     * @param metres distance of the wheel behind the axis when the robot drives forward
     * @throws IllegalArgumentException if the wheel is no idler
     */
    public void setTrail(double metres) {
        double before = trail;
        trail = checked("trail", metres);
        changedIfLegal(() -> trail = before);
    }

    /**
     * Gives the wheel rollers, which let it slide across their axes.
     *
     * @param degrees angle from the rolling direction to the axis of the roller on the ground, seen from above, + to
     *     the left: 0 for an omni wheel, 45 or -45 for a mecanum wheel
     * @throws IllegalArgumentException if the wheel is an idler, or steered
     */
    public void setRollers(double degrees) {
        Double before = rollers;
        rollers = checked("rollers", degrees);
        changedIfLegal(() -> rollers = before);
    }

    private void changedIfLegal(Runnable undo) {
        List<String> problems = new ArrayList<>();
        crossCheck((element, value, legal) -> problems.add(element + " is " + ParameterTable.quote(value)
            + ", legal: " + legal));
        if (!problems.isEmpty()) {
            undo.run();
            throw new IllegalArgumentException(label() + ": " + String.join("; ", problems));
        }
        changed();
    }

    /**
     * Returns z, in the body frame, metres, of the lateral line that contains the robot's centre of rotation. The line
     * passes through the unsteered wheels that grip; if all wheels are steered, through the middle between them.
     *
     * @param wheels of a robot, some of which are steered
     */
    public static double turningLine(List<Wheel> wheels) {
        return wheels.stream().filter(wheel -> wheel.type != IDLER && !wheel.isSteered()).mapToDouble(Wheel::getZ)
            .average().orElseGet(() -> {
            DoubleSummaryStatistics all = wheels.stream().filter(Wheel::isSteered).mapToDouble(Wheel::getZ)
                .summaryStatistics();
            return (all.getMin() + all.getMax()) / 2;
        });
    }

    /**
     * Returns the distance of the steered wheels from the turning line, metres: of the foremost ones if any are in
     * front of it, otherwise of the rearmost ones.
     *
     * @param wheels of a robot, some of which are steered
     * @return 0 if they lie on the line and can't steer
     */
    public static double steeringLength(List<Wheel> wheels) {
        double line = turningLine(wheels);
        DoubleSummaryStatistics steered = wheels.stream().filter(Wheel::isSteered)
            .mapToDouble(wheel -> wheel.getZ() - line).summaryStatistics();
        double length = steered.getMax() > MIN_LENGTH ? steered.getMax() : -steered.getMin();
        return length > MIN_LENGTH ? length : 0;
    }

    @Override
    protected String defaultPicture() {
        return "textures/tyre.png";
    }
}
