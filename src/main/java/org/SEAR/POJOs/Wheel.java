package org.SEAR.POJOs;

import java.io.IOException;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;

/**
 * A wheel of a robot; its axle lies along x, its pose is in the body frame. It belongs to a robot ({@link SEARrobot#addWheel}) and then stands in
 * the robot's XML file; a wheel that was never added is reported when the project is read.
 */
@Described("a wheel of a robot, its axle along x; it stands in the robot's file")
public class Wheel extends Shape {
    /** Type of a wheel that rolls freely in every direction. */
    public static final int IDLER = 0;
    /** Type of a wheel with a motor. */
    public static final int DRIVEN = 1;
    /** Type of a wheel that rolls freely the way it points, and grips across. */
    public static final int FREE = 2;
    /** Nearer than this to the line about which the robot turns a wheel can't steer it, metres. */
    private static final double MIN_LENGTH = 1e-3;

    @Param(doc = "radius", unit = "m", min = SMALL, max = 100, required = true, initial = "0.05")
    private double radius;
    @Param(doc = "size along its axle", unit = "m", min = SMALL, max = 100, required = true, initial = "0.03")
    private double width;
    @Param(doc = "1 for a driven wheel, 0 for an idler, which rolls freely in every direction, 2 for one that rolls freely the way it points",
        values = {"0", "1", "2"}, words = {"idler", "driven", "free"}, max = 2)
    private int type = DRIVEN;
    @Param(doc = "greatest angle to which it is steered, of a wheel in the middle: the inner one of two turns farther, the outer one less; without it"
        + " it isn't steered", unit = "deg", min = 0.1, max = 80)
    private Double steering;
    @Param(doc = "name of the servo that steers it, instead of a greatest angle", text = TextRule.NAME, names = SearObject.class)
    private String steeringServo;
    @Param(doc = "distance of a caster behind the upright axis about which it turns freely, which stands at its x and z; 0 for no caster", unit = "m",
        max = 10)
    private double trail;
    @Param(doc = "angle of its rollers' axes where it touches the ground, seen from above, to the way in which it rolls, + to the left: 0 for an omni"
        + " wheel, 45 or -45 for a mecanum wheel; without it it has no rollers", unit = "deg", min = -80, max = 80)
    private Double rollers;

    /** For reading from a file. */
    protected Wheel() {
    }

    /** A driven wheel. */
    public Wheel(String name, double radius, double width) {
        this(name, radius, width, DRIVEN);
    }

    /** @param type 1 driven, 0 idler, which rolls freely in every direction, 2 rolls freely the way it points */
    public Wheel(String name, double radius, double width, int type) {
        this(name, radius, width, type, 0, 0, 0);
    }

    /** With its centre at (x, y, z) of the body frame, metres. */
    public Wheel(String name, double radius, double width, int type, double x, double y, double z) {
        this(name, radius, width, type, null, x, y, z);
    }

    /**
     * With everything.
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
            faults.add(steering == null ? "steeringServo" : "steering", steering == null ? steeringServo : steering, whatSteers());
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
        return "none for an idler (type 0), which rolls in every direction; a wheel of type 1 or 2 can have it";
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

    /** Metres, before scaling. */
    public double getRadius() {
        return radius;
    }

    /** Metres along the axle, before scaling. */
    public double getWidth() {
        return width;
    }

    /** 1 driven, 0 idler, 2 free. */
    public int getType() {
        return type;
    }

    /** Whether a motor turns it. */
    public boolean isDriven() {
        return type == DRIVEN;
    }

    /** Whether it is steered. */
    public boolean isSteered() {
        return steering != null || steeringServo != null;
    }

    /** Greatest angle, degrees; null if it is not steered, or by a servo. */
    public Double getSteering() {
        return steering;
    }

    /** Name of the servo that steers it; null if none does. */
    public String getSteeringServo() {
        return steeringServo;
    }

    /** Metres; 0 for no caster. */
    public double getTrail() {
        return trail;
    }

    /** Degrees; null for a wheel without rollers. */
    public Double getRollers() {
        return rollers;
    }

    /**
     * Has it steer its robot.
     *
     * @param greatest angle, degrees, of a wheel in the middle
     * @throws IllegalArgumentException if it is an idler, or has rollers
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
     * Has a servo steer it, whose angle is that of a wheel in the middle.
     *
     * @param servo of the same robot; the same for all its steered wheels
     * @throws IllegalArgumentException if that is no servo, or the wheel is an idler, or has rollers
     */
    public void setSteering(SearObject servo) {
        if (servo == null || !servo.isServo()) {
            throw new IllegalArgumentException(label() + ": steering is " + (servo == null ? "missing (None)" : servo.label())
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
     * Makes an idler a caster, which turns freely about an upright axis.
     *
     * @param metres that it is behind the axis when the robot drives forward
     * @throws IllegalArgumentException if it is no idler
     */
    public void setTrail(double metres) {
        double before = trail;
        trail = checked("trail", metres);
        changedIfLegal(() -> trail = before);
    }

    /**
     * Puts rollers on it, on which it slides across their axes.
     *
     * @param degrees angle of the rollers' axes where they touch the ground to the way in which the wheel rolls, + to the left: 0 for an omni wheel,
     *     45 or -45 for a mecanum wheel
     * @throws IllegalArgumentException if it is an idler, or steered
     */
    public void setRollers(double degrees) {
        Double before = rollers;
        rollers = checked("rollers", degrees);
        changedIfLegal(() -> rollers = before);
    }

    private void changedIfLegal(Runnable undo) {
        List<String> problems = new ArrayList<>();
        crossCheck((element, value, legal) -> problems.add(element + " is " + ParameterTable.quote(value) + ", legal: " + legal));
        if (!problems.isEmpty()) {
            undo.run();
            throw new IllegalArgumentException(label() + ": " + String.join("; ", problems));
        }
        changed();
    }

    /**
     * The line across a robot on which the point lies about which it turns: its z in the body frame, metres. It is that of the wheels that grip and
     * are not steered; if all are steered, the middle between them.
     *
     * @param wheels of a robot, some of which are steered
     */
    public static double turningLine(List<Wheel> wheels) {
        return wheels.stream().filter(wheel -> wheel.type != IDLER && !wheel.isSteered()).mapToDouble(Wheel::getZ).average().orElseGet(() -> {
            DoubleSummaryStatistics all = wheels.stream().filter(Wheel::isSteered).mapToDouble(Wheel::getZ).summaryStatistics();
            return (all.getMin() + all.getMax()) / 2;
        });
    }

    /**
     * How far the wheels that steer are from that line, metres: the foremost if there are any before it, else those behind it.
     *
     * @param wheels of a robot, some of which are steered
     * @return 0 if they stand on it and can't steer
     */
    public static double steeringLength(List<Wheel> wheels) {
        double line = turningLine(wheels);
        DoubleSummaryStatistics steered = wheels.stream().filter(Wheel::isSteered).mapToDouble(wheel -> wheel.getZ() - line).summaryStatistics();
        double length = steered.getMax() > MIN_LENGTH ? steered.getMax() : -steered.getMin();
        return length > MIN_LENGTH ? length : 0;
    }

    @Override
    protected String defaultPicture() {
        return "textures/tyre.png";
    }
}
