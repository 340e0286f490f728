package org.SEAR.POJOs;

import java.io.IOException;

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

    @Param(doc = "radius", unit = "m", min = SMALL, max = 100, required = true, initial = "0.05")
    private double radius;
    @Param(doc = "size along its axle", unit = "m", min = SMALL, max = 100, required = true, initial = "0.03")
    private double width;
    @Param(doc = "1 for a driven wheel, 0 for an idler, which rolls freely", values = {"0", "1"}, max = 1)
    private int type = DRIVEN;

    /** For reading from a file. */
    protected Wheel() {
    }

    /** A driven wheel. */
    public Wheel(String name, double radius, double width) {
        this(name, radius, width, DRIVEN);
    }

    /** @param type 1 driven, 0 idler */
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

    /** 1 driven, 0 idler. */
    public int getType() {
        return type;
    }

    /** Whether a motor turns it. */
    public boolean isDriven() {
        return type == DRIVEN;
    }

    @Override
    protected String defaultPicture() {
        return "textures/tyre.png";
    }
}
