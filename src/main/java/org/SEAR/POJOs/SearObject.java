// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.NamedValues;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.ScriptText;
import org.SEAR.grammar.TextRule;

/**
 * An object of the grammar: a name and a pose. An object that a script or program creates writes its XML file when it
 * is created and after each change. An object that was read from a file belongs to its {@code Project} and is
 * immutable. One thread at a time.
 *
 * <p>A class of the grammar consists of fields with {@link Param}, a constructor without arguments for reading,
 * constructors that end with {@code created(MyClass.class)}, and setters of the form
 * {@code mass = checked("mass", newMass); changed();}.
 */
public abstract class SearObject {
    /** Largest legal coordinate of a position, metres. */
    static final double FAR = 200000;
    /** Largest legal angle of a rotation, degrees. */
    static final double TURNS = 36000;

    @Param(doc = "name of the object and of its file", text = TextRule.NAME, required = true)
    private String name;
    @Param(doc = "position northwards; on a robot to the left", unit = "m", min = -FAR, max = FAR)
    private double x;
    @Param(doc = "position upwards", unit = "m", min = -FAR, max = FAR)
    private double y;
    @Param(doc = "position eastwards; on a robot forwards", unit = "m", min = -FAR, max = FAR)
    private double z;
    @Param(doc = "rotation about the x axis", unit = "deg", min = -TURNS, max = TURNS)
    private double rx;
    @Param(doc = "rotation about the y axis, counter-clockwise from above", unit = "deg", min = -TURNS, max = TURNS)
    private double ry;
    @Param(doc = "rotation about the z axis", unit = "deg", min = -TURNS, max = TURNS)
    private double rz;

    private enum Life { BEING_MADE, LIVE, READ }

    private Life life;
    private SEARrobot robot;
    private SearObject mover;
    /**
     * Whether the file lies in the robot's own folder, because a part of another robot with the same name has the plain
     * file.
     */
    private boolean aside;
    private String fullName;
    /** Number of simulations started before the object was created. */
    private int starts;

    /** For reading from a file. */
    protected SearObject() {
        life = Life.READ;
    }

    /** @param name becomes the name of the file */
    protected SearObject(String name) {
        life = Life.BEING_MADE;
        this.name = ScriptText.of(name);
    }

    /**
     * Checks all values, then writes the file. Each public constructor has to call it last.
     *
     * @param constructed the constructor's class; the call does nothing in the constructor of a superclass
     * @throws IllegalArgumentException with all problems; nothing is written then
     */
    protected final void created(Class<?> constructed) {
        if (getClass() != constructed) {
            return;
        }
        checkWhole();
        boolean taken = isTaken();
        life = Life.LIVE;
        starts = ScriptSessions.ALL.starts();
        write();
        if (!ObjectStores.isRedirected()) {
            Notices.made(label(), name, taken);
        }
    }

    private void checkWhole() {
        List<String> problems = new ArrayList<>(ParameterTable.of(getClass()).problems(this, ""));
        crossCheck((element, value, legal) -> problems.add(element + " is " + ParameterTable.quote(value)
            + ", legal: " + legal));
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException(label() + ": " + String.join("; ", problems));
        }
    }

    private boolean isTaken() {
        try {
            return ObjectStores.get().replaces(name);
        } catch (IOException e) {
            throw new UncheckedIOException(label() + " could not be written: " + e.getMessage(), e);
        }
    }

    /** Adds the problems of combined values, beyond the legal range of each. Called on creation and after reading. */
    protected void crossCheck(Faults faults) {
    }

    /**
     * Writes the file again.
     *
     * @throws UncheckedIOException if the file can't be written; the old file stays complete
     * @throws IllegalStateException if the object is not in the project
     */
    protected final void changed() {
        if (life == Life.LIVE) {
            rewrite();
            tell("changed", "");
        }
    }

    /** Writes the file, whether it exists or not. */
    final void write() {
        try {
            save();
        } catch (IOException e) {
            throw new UncheckedIOException(label() + " could not be written: " + e.getMessage(), e);
        }
    }

    /** Writes the file only if it still exists: a deleted or renamed object must not reappear under its old name. */
    private void rewrite() {
        try {
            if (!isKept()) {
                throw new IllegalStateException(label() + " is not in the project: since this object was created it "
                    + "was deleted or renamed there, or"
                    + " another project was opened; sear.edit({\"do\": \"set\", ...}) changes the project's present "
                        + "objects by name");
            }
            save();
        } catch (IOException e) {
            throw new UncheckedIOException(label() + " could not be written: " + e.getMessage(), e);
        }
    }

    private void moved() {
        if (life == Life.LIVE) {
            rewrite();
            tell("moved", "; sear.edit({\"do\": \"set\", ...}) moves it immediately");
        }
    }

    private void tell(String what, String instead) {
        if (!ObjectStores.isRedirected()) {
            Notices.changed(label(), what, instead, starts);
        }
    }

    /** Returns whether the object's file exists. */
    boolean isKept() throws IOException {
        return ObjectStores.get().keeps(getFileName(), isRobotPart());
    }

    void save() throws IOException {
        ObjectStores.get().write(this, isRobotPart());
    }

    /** Returns whether the file lies in {@code robot/} even before the object is added to a robot. */
    boolean isRobotPart() {
        return robot != null;
    }

    /**
     * Checks a value before it is assigned.
     *
     * @throws IllegalArgumentException that names object, parameter, value and legal range
     */
    protected final double checked(String parameter, double value) {
        check(parameter, value);
        return value + 0.0;
    }

    /**
     * Checks a value before it is assigned.
     *
     * @throws IllegalArgumentException that names object, parameter, value and legal values
     */
    protected final int checked(String parameter, int value) {
        check(parameter, value);
        return value;
    }

    /**
     * Checks a value before it is assigned.
     *
     * @throws IllegalArgumentException that names object, parameter, value and legal form
     */
    protected final String checked(String parameter, String value) {
        check(parameter, value);
        return value;
    }

    /**
     * Checks a value before it is assigned.
     *
     * @throws IllegalStateException if the object was read from a file
     */
    protected final boolean checked(String parameter, boolean value) {
        check(parameter, value);
        return value;
    }

    private void check(String parameter, Object value) {
        checkChangeable();
        String fixed = whyFixed(parameter);
        if (fixed != null) {
            throw new IllegalArgumentException(label() + ": " + parameter + " can't be set: " + fixed);
        }
        Parameter described = ParameterTable.of(getClass()).get(parameter);
        if (!described.isLegal(value)) {
            throw new IllegalArgumentException(label() + ": " + parameter + " is " + ParameterTable.quote(value)
                + ", legal: " + described.legal());
        }
    }

    /**
     * Returns why this kind of object has a fixed parameter, and what to do instead; null if the parameter can be set.
     */
    String whyFixed(String parameter) {
        return null;
    }

    /**
     * Returns why the object can't be a component of a robot, as text after its name, and what is legal; null if it
     * can.
     */
    String whyNoComponent() {
        return null;
    }

    /** Returns whether it is a servo, which can steer a wheel. */
    boolean isServo() {
        return false;
    }

    final void checkChangeable() {
        if (life == Life.READ) {
            throw new IllegalStateException(label() + " was read from a project and can't be changed; create objects "
                + "with their constructors");
        }
    }

    /**
     * Sets parameters by their names in the object's file, also those without a method: {@code box.set({"onGround":
     * False})}. If a value is invalid or the values don't fit together, none is set.
     *
     * @param values number, text, True or False by name; None clears; a group of parameters is a dictionary, several
     *     values are a list
     * @throws IllegalArgumentException that names object, parameter, value and legal values
     */
    public void set(Map<String, ?> values) {
        checkChangeable();
        NamedValues named = new NamedValues(this, label(), SearObject::isGiven);
        boolean done = false;
        try {
            named.set(values);
            checkWhole();
            valuesSet();
            done = true;
        } finally {
            if (!done) {
                named.undo();
            }
        }
        changed();
    }

    /**
     * Creates an object of any class of the grammar from its parameters by name, as {@link #set} takes them.
     *
     * @param type the object's class
     * @param values the name, and the parameters that differ from the defaults
     * @throws IllegalArgumentException with all problems; nothing is written then
     */
    public static <T extends SearObject> T make(Class<T> type, Map<String, ?> values) {
        SearObject object = (SearObject) ParameterTable.of(type).newInstance();
        object.life = Life.BEING_MADE;
        new NamedValues(object, type.getSimpleName(), SearObject::isPart).set(values);
        object.valuesSet();
        object.created(type);
        return type.cast(object);
    }

    private static boolean isPart(Parameter parameter) {
        return parameter.getTextRule() == TextRule.COMPONENT || SearObject.class.isAssignableFrom(parameter.getType());
    }

    /** Returns whether a parameter is the name or a part, which {@link #set} does not set. */
    private static boolean isGiven(Parameter parameter) {
        return parameter.getName().equals("name") || isPart(parameter);
    }

    /**
     * Updates dependent data after parameters were set by name. Called before the file is written.
     *
     * @throws IllegalArgumentException if the values don't fit to the object's other data
     */
    void valuesSet() {
    }

    /**
     * Returns the constant properties by which the tab draws the object, besides pose and surface, by the names of
     * their JSON fields.
     */
    public final Map<String, Object> getDrawingProperties() {
        Map<String, Object> properties = new LinkedHashMap<>();
        addDrawingProperties(properties);
        return properties;
    }

    /** Adds the kind's {@link #getDrawingProperties}: numbers, texts, booleans and arrays. Most kinds have none. */
    protected void addDrawingProperties(Map<String, Object> properties) {
    }

    /** Returns class and name: {@code Box "Box1_name"}. */
    final String label() {
        return getClass().getSimpleName() + " \"" + name + "\"";
    }

    final SEARrobot robot() {
        return robot;
    }

    final void setRobot(SEARrobot newRobot) {
        robot = newRobot;
    }

    /**
     * Returns the motor or servo that turns the object; null if there is none, or if the object was read from a file.
     */
    final SearObject getMover() {
        return mover;
    }

    final void setMover(SearObject newMover) {
        mover = newMover;
    }

    final void setAside(boolean newAside) {
        aside = newAside;
    }

    final void setFullName(String newFullName) {
        fullName = newFullName;
    }

    /** Returns the name, which is also the name of the XML file. */
    public String getName() {
        return name;
    }

    /**
     * Returns the name of the file below {@code environment/} or {@code robot/}, without .xml: the name, or
     * {@code robot/name} for a part in its robot's own folder.
     */
    public final String getFileName() {
        return aside ? robot.getName() + "/" + name : name;
    }

    /**
     * Returns the name by which scripts address the object: its name, or {@code robot/name} if another robot of the
     * project has a part with the same name. Only an object that was read with its project knows the other robots'
     * parts; for every other object this is the name.
     */
    public final String getFullName() {
        return fullName == null ? name : fullName;
    }

    public double getX() {
        return x;
    }

    public double getY() {
        return y;
    }

    public double getZ() {
        return z;
    }

    public double getRx() {
        return rx;
    }

    public double getRy() {
        return ry;
    }

    public double getRz() {
        return rz;
    }

    /** Moves the object: metres in the world frame, or in the body frame of its robot. */
    public void move(double newX, double newY, double newZ) {
        double checkedX = checked("x", newX);
        double checkedY = checked("y", newY);
        z = checked("z", newZ);
        x = checkedX;
        y = checkedY;
        moved();
    }

    /** Rotates the object: degrees about the three axes, in the order of jME's Quaternion.fromAngles. */
    public void rotate(double newRx, double newRy, double newRz) {
        double checkedX = checked("rx", newRx);
        double checkedY = checked("ry", newRy);
        rz = checked("rz", newRz);
        rx = checkedX;
        ry = checkedY;
        moved();
    }

    /** Sets the position without a check and without writing the file. */
    final void setPosition(double newX, double newY, double newZ) {
        x = newX + 0.0;
        y = newY + 0.0;
        z = newZ + 0.0;
    }

    /** Sets the pose during construction; {@link #created} checks it. */
    protected final void pose(double newX, double newY, double newZ, double newRx, double newRy, double newRz) {
        x = newX + 0.0;
        y = newY + 0.0;
        z = newZ + 0.0;
        rx = newRx + 0.0;
        ry = newRy + 0.0;
        rz = newRz + 0.0;
    }

    /** Returns class and name: {@code Box "Box1_name"}. */
    @Override
    public String toString() {
        return label();
    }
}
