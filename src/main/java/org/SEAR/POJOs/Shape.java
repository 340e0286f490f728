package org.SEAR.POJOs;

import java.util.Map;
import java.util.Set;
import org.SEAR.grammar.ColorNames;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;

/** A thing with a surface, a mass and a picture. */
public abstract class Shape extends PlacedObject {
    /** Smallest size of anything, metres. */
    static final double SMALL = 0.0001;
    /** Largest size of anything, metres. */
    static final double LARGE = 100000;
    /** Lightest thing that moves, kg: speeds and forces of lighter ones are beyond single precision. */
    static final double LIGHT = 1e-6;
    /** Heaviest thing, kg. */
    static final double HEAVY = 1e6;
    /** Fastest thing at the start, m/s. */
    private static final double FAST = 1000;
    /** Fastest turning at the start, degrees a second. */
    private static final double TURNING = 100000;
    /** How warm everything is that has no temperature of its own, degrees Celsius. */
    public static final double AMBIENT = 20;
    /** What says how it moves at the start; looked for in each parameter of each object. */
    private static final Set<String> LAUNCHING = Set.of("velocityX", "velocityY", "velocityZ", "spinX", "spinY", "spinZ");
    /** The pictures of surfaces that come with SEAR, and how many metres wide and high one is. */
    private static final Map<String, Double> TILES = Map.of("textures/tiles.png", 1.0, "textures/brick.png", 1.0, "textures/grass.png", 2.0);

    @Param(doc = "mass; 0 fixes the object in place", unit = "kg", min = LIGHT, orZero = true, max = HEAVY)
    private double mass;
    @Param(doc = "picture wrapped around the surface: a file below assets; without it the default picture, or plain if it has a colour",
        text = TextRule.ASSET)
    private String image;
    @Param(doc = "colour of the surface where it has no picture, and in drawings", text = TextRule.COLOR)
    private String color;
    @Param(doc = "factor on the size along x", min = 0.0001, max = 10000)
    private double scaleX = 1;
    @Param(doc = "factor on the size along y", min = 0.0001, max = 10000)
    private double scaleY = 1;
    @Param(doc = "factor on the size along z", min = 0.0001, max = 10000)
    private double scaleZ = 1;
    @Param(doc = "whether beams of distance sensors and LIDARs see the object")
    private boolean visibleToSensors = true;

    @Param(doc = "coefficient of friction; where two objects touch the product of both counts; without it 0.8, for parts of a robot 0.3, "
        + "for its wheels 1.25", max = 10)
    private Double friction;
    @Param(doc = "coefficient of restitution: 0 stays where it falls, 1 bounces back as high; where two objects touch the greater counts; "
        + "without it 0", max = 1)
    private Double restitution;
    @Param(doc = "coefficient of rolling friction: the force that brakes what rolls, as a share of its weight; where two objects touch the sum "
        + "of both counts; without it 0.001", max = 1)
    private Double rollingFriction;
    @Param(doc = "velocity of its centre of mass at the start, northwards; without it 0", unit = "m/s", min = -FAST, max = FAST)
    private Double velocityX;
    @Param(doc = "velocity of its centre of mass at the start, upwards; without it 0", unit = "m/s", min = -FAST, max = FAST)
    private Double velocityY;
    @Param(doc = "velocity of its centre of mass at the start, eastwards; without it 0", unit = "m/s", min = -FAST, max = FAST)
    private Double velocityZ;
    @Param(doc = "speed of its turning at the start about the world's x; without it 0", unit = "deg/s", min = -TURNING, max = TURNING)
    private Double spinX;
    @Param(doc = "speed of its turning at the start about the world's y, counter-clockwise seen from above; without it 0",
        unit = "deg/s", min = -TURNING, max = TURNING)
    private Double spinY;
    @Param(doc = "speed of its turning at the start about the world's z; without it 0", unit = "deg/s", min = -TURNING, max = TURNING)
    private Double spinZ;
    @Param(doc = "temperature of its surface, for infrared cameras; without it that of its surroundings, 20 degC", unit = "degC",
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

    /** Sets the picture while the object is being made. */
    final void wrap(String newImage) {
        image = newImage;
    }

    /** Sets the visibility while the object is being made. */
    final void show(boolean visible) {
        visibleToSensors = visible;
    }

    /** kg; 0 for an object that is fixed in place. */
    public double getMass() {
        return mass;
    }

    /** Path of the picture below assets; null for the default picture. */
    public String getImage() {
        return image;
    }

    /**
     * Path below assets of the picture to show: its own, else, if it has no colour of its own, the default picture of its kind. Null for a plain
     * surface in {@link #getColor its colour}; for a model without a colour of its own, for the model's textures.
     */
    public String getPicture() {
        String path = image == null && color == null ? defaultPicture() : image;
        return path != null && path.startsWith("./") ? path.substring(2) : path;
    }

    /** Metres after which its picture is repeated, so that it has its true size on shapes of any size; null if it covers each side once. */
    public Double getPictureTile() {
        return getPicture() == null ? null : TILES.get(getPicture());
    }

    /** The picture of a shape without one, which comes with SEAR; null for none. */
    protected String defaultPicture() {
        return null;
    }

    /** Its colour where it has no picture, and in drawings, as {@code #rrggbb}: its own, else that of its kind. */
    public final String getColor() {
        return color == null ? defaultColor() : ColorNames.hex(color);
    }

    /** Whether it has a colour of its own. */
    public final boolean hasColor() {
        return color != null;
    }

    /** The colour of a shape without one, as {@code #rrggbb}. */
    protected String defaultColor() {
        return "#999999";
    }

    /** Factor on the size along x. */
    public double getScaleX() {
        return scaleX;
    }

    /** Factor on the size along y. */
    public double getScaleY() {
        return scaleY;
    }

    /** Factor on the size along z. */
    public double getScaleZ() {
        return scaleZ;
    }

    /** Whether beams see it. */
    public boolean isVisibleToSensors() {
        return visibleToSensors;
    }

    /** Whether it is the ground, on which robots drive and things are placed: a floor or the terrain. */
    public boolean isGround() {
        return false;
    }

    /** @param kg 1e-6 to 1e6, or 0; 0 fixes the object in place, untouched by gravity and collisions */
    public void setMass(double kg) {
        double checkedMass = checked("mass", kg);
        if (checkedMass == 0 && isLaunched()) {
            throw new IllegalArgumentException(label() + ": mass is 0, legal: more than 0 kg for a thing with a velocity or a spin");
        }
        mass = checkedMass;
        changed();
    }

    /**
     * Wraps a picture around it.
     *
     * @param newImage path below assets; null for the default picture
     */
    public void setImage(String newImage) {
        image = checked("image", newImage);
        changed();
    }

    /**
     * Gives it a colour: without a picture its surface is plain, and drawings such as the tab's show it in this colour.
     *
     * @param newColor {@code #rrggbb}, or one of the names red, orange, brown ... in {@code docs/objects.md}; null for that of its kind
     */
    public void setColor(String newColor) {
        color = checked("color", newColor);
        changed();
    }

    /** Whether beams see it. */
    public void setVisibleToSensors(boolean visible) {
        visibleToSensors = checked("visibleToSensors", visible);
        changed();
    }

    /** Coefficient of friction; null if the object has the default, 0.8 (a part of a robot 0.3, a wheel 1.25). */
    public Double getFriction() {
        return friction;
    }

    /** Coefficient of restitution; null if the object has the default, 0. */
    public Double getRestitution() {
        return restitution;
    }

    /** Coefficient of rolling friction; null if the object has the default, 0.001. */
    public Double getRollingFriction() {
        return rollingFriction;
    }

    /**
     * Sets the coefficient of friction.
     *
     * @param coefficient 0 to 10; where two objects touch the product of both counts
     */
    public void setFriction(double coefficient) {
        friction = checked("friction", coefficient);
        changed();
    }

    /**
     * Sets how much of its speed comes back when something hits it.
     *
     * @param coefficient 0 to 1; where two objects touch the greater counts
     */
    public void setRestitution(double coefficient) {
        restitution = checked("restitution", coefficient);
        changed();
    }

    /**
     * Sets what brakes the object when it rolls.
     *
     * @param coefficient 0 to 1, a share of its weight; where two objects touch the sum of both counts
     */
    public void setRollingFriction(double coefficient) {
        rollingFriction = checked("rollingFriction", coefficient);
        changed();
    }

    /**
     * Stretches the object along its own axes.
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
     * Stretches the object along all axes.
     *
     * @param factor 0.0001 to 10000
     */
    public void scale(double factor) {
        scale(factor, factor, factor);
    }

    /**
     * Gives it a velocity: what it starts with. While a simulation runs that was started after the object was made it has this velocity there at
     * once, between two steps, and its file and the next start stay as they are.
     *
     * @param newX m/s northwards, of its centre of mass, -1000 to 1000
     * @param newY m/s upwards
     * @param newZ m/s eastwards
     * @throws IllegalArgumentException if it is fixed (mass 0) or a part of a robot
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
     * Has it turn about its centre of mass: what it starts with; while a simulation runs, at once, as {@link #setVelocity}.
     *
     * @param newX degrees a second about the world's x, by the right hand, -100000 to 100000
     * @param newY about the world's y, counter-clockwise seen from above
     * @param newZ about the world's z
     * @throws IllegalArgumentException if it is fixed (mass 0) or a part of a robot
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

    /** Temperature of its surface, degrees Celsius; null if it is as warm as its surroundings, {@link #AMBIENT}. */
    public Double getTemperature() {
        return temperature;
    }

    /** @param celsius temperature of its surface, -273.15 to 5000, for infrared cameras; without it {@link #AMBIENT} */
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
            throw new IllegalArgumentException(label() + " is a part of " + robot().label() + " and has no " + what + " of its own: the robot moves");
        }
        if (mass == 0) {
            throw new IllegalArgumentException(label() + " is fixed (mass 0) and can't have a " + what + ", legal: setMass(kg) before");
        }
    }

    /** Velocity of its centre of mass at the start: m/s along the world's {x, y, z}. */
    public final double[] getVelocity() {
        return new double[] {orZero(velocityX), orZero(velocityY), orZero(velocityZ)};
    }

    /** Its turning at the start: degrees a second about the world's {x, y, z}. */
    public final double[] getSpin() {
        return new double[] {orZero(spinX), orZero(spinY), orZero(spinZ)};
    }

    /** Whether it has a velocity or a spin at the start. */
    public final boolean isLaunched() {
        return launching() != null;
    }

    /** Whether a parameter says how it moves at the start. */
    static boolean isLaunching(String parameter) {
        return LAUNCHING.contains(parameter);
    }

    /** The first parameter by which it moves at the start; null if there is none. */
    private Parameter launching() {
        return ParameterTable.of(getClass()).getParameters().stream()
            .filter(parameter -> isLaunching(parameter.getName()) && parameter.get(this) != null && !parameter.get(this).equals(0.0)).findFirst()
            .orElse(null);
    }

    /** Tells that it moves at the start and must not. */
    public final void toFaultsOfLaunch(Faults faults, String legal) {
        Parameter launching = launching();
        if (launching != null) {
            faults.add(launching.getName(), launching.get(this), legal);
        }
    }

    @Override
    String whyNoComponent() {
        return isLaunched() ? " has a velocity or a spin, which a component can't have, legal: setVelocity(0, 0, 0) and setSpin(0, 0, 0) before"
            : super.whyNoComponent();
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (mass == 0) {
            toFaultsOfLaunch(faults, "0 for what is fixed; with a mass above 0 kg it can have it");
        }
    }
}
