// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Map;
import java.util.Set;
import org.SEAR.grammar.ColorNames;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;

/** An object with a surface, a mass and a picture. */
public abstract class Shape extends PlacedObject {
    /** Smallest size, metres. */
    static final double SMALL = 0.0001;
    /** Largest size, metres. */
    static final double LARGE = 100000;
    /** Smallest mass of a moving object, kg: below it speeds and forces exceed single precision. */
    static final double LIGHT = 1e-6;
    /** Largest mass, kg. */
    static final double HEAVY = 1e6;
    /** Largest initial speed along an axis, m/s. */
    private static final double FAST = 1000;
    /** Largest initial angular velocity about an axis, deg/s. */
    private static final double TURNING = 100000;
    /** Temperature of an object without a temperature of its own, degrees Celsius. */
    public static final double AMBIENT = 20;
    /** Parameters of the initial velocity and spin. */
    private static final Set<String> LAUNCHING = Set.of("velocityX", "velocityY", "velocityZ", "spinX",
        "spinY", "spinZ");
    /** Pictures of surfaces that come with SEAR, and the width and height of one repetition, metres. */
    private static final Map<String, Double> TILES = Map.of("textures/tiles.png", 1.0, "textures/brick.png", 1.0,
        "textures/grass.png", 2.0);

    @Param(doc = "mass; 0 fixes the object in place", unit = "kg", min = LIGHT, orZero = true, max = HEAVY)
    private double mass;
    @Param(doc = "picture on the surface; otherwise the default picture, or plain if it has a colour",
        text = TextRule.ASSET)
    private String image;
    @Param(doc = "colour of drawings, and of a surface without a picture", text = TextRule.COLOR)
    private String color;
    @Param(doc = "scale factor along x", min = 0.0001, max = 10000)
    private double scaleX = 1;
    @Param(doc = "scale factor along y", min = 0.0001, max = 10000)
    private double scaleY = 1;
    @Param(doc = "scale factor along z", min = 0.0001, max = 10000)
    private double scaleZ = 1;
    @Param(doc = "whether beams of distance sensors and LIDARs hit the object")
    private boolean visibleToSensors = true;

    @Param(doc = "coefficient of friction; a contact uses the product of both; default 0.8 (robot parts 0.3, wheels "
        + "1.25)", max = 10)
    private Double friction;
    @Param(doc = "coefficient of restitution: 0 no bounce, 1 full bounce; a contact uses the greater; default 0",
        max = 1)
    private Double restitution;
    @Param(doc = "coefficient of rolling friction: braking force divided by weight; a contact uses the sum of both; "
        + "default 0.001", max = 1)
    private Double rollingFriction;
    @Param(doc = "initial velocity of its centre of mass, northwards; default 0", unit = "m/s", min = -FAST, max = FAST)
    private Double velocityX;
    @Param(doc = "initial velocity of its centre of mass, upwards; default 0", unit = "m/s", min = -FAST, max = FAST)
    private Double velocityY;
    @Param(doc = "initial velocity of its centre of mass, eastwards; default 0", unit = "m/s", min = -FAST, max = FAST)
    private Double velocityZ;
    @Param(doc = "initial angular velocity about the world's x; default 0", unit = "deg/s", min = -TURNING,
        max = TURNING)
    private Double spinX;
    @Param(doc = "initial angular velocity about the world's y, counter-clockwise from above; default 0",
        unit = "deg/s", min = -TURNING, max = TURNING)
    private Double spinY;
    @Param(doc = "initial angular velocity about the world's z; default 0", unit = "deg/s", min = -TURNING,
        max = TURNING)
    private Double spinZ;
    @Param(doc = "surface temperature for infrared cameras; default 20 degC, as its surroundings", unit = "degC",
        min = -273.15, max = 5000)
    private Double temperature;
    private final int madeAfter = ScriptSessions.ALL.starts();

    /** For reading from a file. */
    protected Shape() {
    }

    /** @param mass kg, 0 to fix it */
    protected Shape(String name, double mass) {
        super(name);
        this.mass = mass + 0.0;
    }

    /** Sets the picture during construction. */
    final void wrap(String newImage) {
        image = newImage;
    }

    /** Sets the visibility during construction. */
    final void show(boolean visible) {
        visibleToSensors = visible;
    }

    public double getMass() {
        return mass;
    }

    public String getImage() {
        return image;
    }

    /**
     * Returns the path below assets of the picture to show: the image, or the default picture of the kind if the object
     * has no colour either. Null for a plain surface in {@link #getColor its colour}; for a model without a colour, for
     * the model's textures.
     */
    public String getPicture() {
        String path = image == null && color == null ? defaultPicture() : image;
        return path != null && path.startsWith("./") ? path.substring(2) : path;
    }

    /**
     * Returns the width and height of one repetition of the picture, metres; null if the picture covers each side once.
     */
    public Double getPictureTile() {
        return getPicture() == null ? null : TILES.get(getPicture());
    }

    /** Returns the default picture of the kind, which comes with SEAR; null for none. */
    protected String defaultPicture() {
        return null;
    }

    /** Returns the colour of surface and drawings as {@code #rrggbb}: the object's own or the default of its kind. */
    public final String getColor() {
        return color == null ? defaultColor() : ColorNames.hex(color);
    }

    public final boolean hasColor() {
        return color != null;
    }

    /** Returns the default colour of the kind, as {@code #rrggbb}. */
    protected String defaultColor() {
        return "#999999";
    }

    public double getScaleX() {
        return scaleX;
    }

    public double getScaleY() {
        return scaleY;
    }

    public double getScaleZ() {
        return scaleZ;
    }

    public boolean isVisibleToSensors() {
        return visibleToSensors;
    }

    /** Adds {@code color}, {@code colored}: whether it is the object's own, {@code loose}: whether it has a mass. */
    @Override
    protected void addDrawingProperties(Map<String, Object> properties) {
        properties.put("color", getColor());
        properties.put("colored", hasColor());
        properties.put("loose", mass > 0);
    }

    /** Returns whether the object is ground, on which robots drive and objects are placed: a floor or the terrain. */
    public boolean isGround() {
        return false;
    }

    /** @param kg 1e-6 to 1e6, or 0; 0 fixes the object in place, where neither gravity nor collisions move it */
    public void setMass(double kg) {
        double checkedMass = checked("mass", kg);
        if (checkedMass == 0 && isLaunched()) {
            throw new IllegalArgumentException(label() + ": mass is 0, legal: more than 0 kg for an object with a "
                + "velocity or a spin");
        }
        mass = checkedMass;
        changed();
    }

    /**
     * Sets the picture.
     *
     * @param newImage path below assets; null for the default picture
     */
    public void setImage(String newImage) {
        image = checked("image", newImage);
        changed();
    }

    /**
     * Sets the colour of a surface without a picture, and of drawings such as the tab's map.
     *
     * @param newColor {@code #rrggbb}, or one of the names red, orange, brown ... in {@code docs/objects.md}; null for
     *     the default of its kind
     */
    public void setColor(String newColor) {
        color = checked("color", newColor);
        changed();
    }

    public void setVisibleToSensors(boolean visible) {
        visibleToSensors = checked("visibleToSensors", visible);
        changed();
    }

    public Double getFriction() {
        return friction;
    }

    public Double getRestitution() {
        return restitution;
    }

    public Double getRollingFriction() {
        return rollingFriction;
    }

    /**
     * Sets the coefficient of friction.
     *
     * @param coefficient 0 to 10; a contact uses the product of both objects' coefficients
     */
    public void setFriction(double coefficient) {
        friction = checked("friction", coefficient);
        changed();
    }

    /**
     * Sets the coefficient of restitution.
     *
     * @param coefficient 0 to 1; a contact uses the greater of both objects' coefficients
     */
    public void setRestitution(double coefficient) {
        restitution = checked("restitution", coefficient);
        changed();
    }

    /**
     * Sets the coefficient of rolling friction.
     *
     * @param coefficient 0 to 1, the braking force as a fraction of the weight; a contact uses the sum of both objects'
     *     coefficients
     */
    public void setRollingFriction(double coefficient) {
        rollingFriction = checked("rollingFriction", coefficient);
        changed();
    }

    /**
     * Scales the object along its own axes.
     *
     * @param newScaleX factor, 0.0001 to 10000
     */
    public void scale(double newScaleX, double newScaleY, double newScaleZ) {
        double checkedX = checked("scaleX", newScaleX);
        double checkedY = checked("scaleY", newScaleY);
        scaleZ = checked("scaleZ", newScaleZ);
        scaleX = checkedX;
        scaleY = checkedY;
        changed();
    }

    /**
     * Scales the object along all axes.
     *
     * @param factor 0.0001 to 10000
     */
    public void scale(double factor) {
        scale(factor, factor, factor);
    }

    /**
     * Sets the initial velocity. If a simulation runs that was started after the object was created, the call sets the
     * velocity in that simulation between two steps, and leaves the file unchanged.
     *
     * @param newX m/s northwards, of the centre of mass, -1000 to 1000
     * @param newY m/s upwards
     * @param newZ m/s eastwards
     * @throws IllegalArgumentException if the object is fixed (mass 0) or a part of a robot
     */
    public void setVelocity(double newX, double newY, double newZ) {
        double checkedX = checked("velocityX", newX);
        double checkedY = checked("velocityY", newY);
        double checkedZ = checked("velocityZ", newZ);
        checkLaunch("velocity");
        ScriptSession.Acts running = ScriptSessions.ALL.actsFor(madeAfter);
        if (running != null) {
            running.setVelocity(getName(), checkedX, checkedY, checkedZ);
            return;
        }
        velocityX = orNothing(checkedX);
        velocityY = orNothing(checkedY);
        velocityZ = orNothing(checkedZ);
        changed();
    }

    /**
     * Sets the initial angular velocity about the centre of mass; in a running simulation the present one, as
     * {@link #setVelocity}.
     *
     * @param newX degrees a second about the world's x, by the right-hand rule, -100000 to 100000
     * @param newY about the world's y, counter-clockwise seen from above
     * @param newZ about the world's z
     * @throws IllegalArgumentException if the object is fixed (mass 0) or a part of a robot
     */
    public void setSpin(double newX, double newY, double newZ) {
        double checkedX = checked("spinX", newX);
        double checkedY = checked("spinY", newY);
        double checkedZ = checked("spinZ", newZ);
        checkLaunch("spin");
        ScriptSession.Acts running = ScriptSessions.ALL.actsFor(madeAfter);
        if (running != null) {
            running.setSpin(getName(), checkedX, checkedY, checkedZ);
            return;
        }
        spinX = orNothing(checkedX);
        spinY = orNothing(checkedY);
        spinZ = orNothing(checkedZ);
        changed();
    }

    /** Returns the surface temperature, degrees Celsius; null for {@link #AMBIENT}. */
    public Double getTemperature() {
        return temperature;
    }

    /** @param celsius surface temperature, -273.15 to 5000, for infrared cameras */
    public void setTemperature(double celsius) {
        temperature = checked("temperature", celsius);
        changed();
    }

    private static Double orNothing(double value) {
        return value == 0 ? null : Double.valueOf(value);
    }

    private static double orZero(Double value) {
        return value == null ? 0 : value;
    }

    private void checkLaunch(String what) {
        if (robot() != null) {
            throw new IllegalArgumentException(label() + " is a part of " + robot().label() + " and has no " + what
                + " of its own: the robot moves");
        }
        if (mass == 0) {
            throw new IllegalArgumentException(label() + " is fixed (mass 0) and can't have a " + what
                + ", legal: setMass(kg) before");
        }
    }

    /** Returns the initial velocity of the centre of mass: m/s along the world's {x, y, z}. */
    public final double[] getVelocity() {
        return new double[] {orZero(velocityX), orZero(velocityY), orZero(velocityZ)};
    }

    /** Returns the initial angular velocity: degrees a second about the world's {x, y, z}. */
    public final double[] getSpin() {
        return new double[] {orZero(spinX), orZero(spinY), orZero(spinZ)};
    }

    /** Returns whether the object has an initial velocity or spin. */
    public final boolean isLaunched() {
        return launching() != null;
    }

    /** Returns whether a parameter is part of the initial velocity or spin. */
    static boolean isLaunching(String parameter) {
        return LAUNCHING.contains(parameter);
    }

    /** Returns the first non-zero parameter of the initial velocity or spin; null if there is none. */
    private Parameter launching() {
        return ParameterTable.of(getClass()).getParameters().stream()
            .filter(parameter -> isLaunching(parameter.getName()) && parameter.get(this) != null && !parameter.get(this)
                .equals(0.0)).findFirst()
            .orElse(null);
    }

    /** Adds a fault if the object has an initial velocity or spin. */
    public final void toFaultsOfLaunch(Faults faults, String legal) {
        Parameter launching = launching();
        if (launching != null) {
            faults.add(launching.getName(), launching.get(this), legal);
        }
    }

    @Override
    String whyNoComponent() {
        return isLaunched() ? " has a velocity or a spin, which a component can't have, legal: setVelocity(0, 0, 0) "
            + "and setSpin(0, 0, 0) before" : super.whyNoComponent();
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (mass == 0) {
            toFaultsOfLaunch(faults, "0 for a fixed object; an object with a mass above 0 kg can move");
        }
    }
}
