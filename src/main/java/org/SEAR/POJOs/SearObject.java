package org.SEAR.POJOs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
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
 * Anything of the object grammar: a name and a pose. An object that a script or program creates writes its XML file when it is created and after
 * each change; an object that was read from a file belongs to its {@code Project} and never changes. One thread at a time.
 *
 * <p>How to write a class of the grammar: fields with {@link Param}, a constructor without arguments for reading, constructors that end with
 * {@code created(MyClass.class)}, and setters of the form {@code mass = checked("mass", newMass); changed();}.
 */
public abstract class SearObject {
    /** Metres from the origin that an object may be away. */
    static final double FAR = 200000;
    /** Degrees that an object may be turned at once. */
    static final double TURNS = 36000;

    @Param(doc = "name of the object, and of its file", text = TextRule.NAME, required = true)
    private String name;
    @Param(doc = "position northwards; to the left on a robot", unit = "m", min = -FAR, max = FAR)
    private double x;
    @Param(doc = "position upwards", unit = "m", min = -FAR, max = FAR)
    private double y;
    @Param(doc = "position eastwards; forwards on a robot", unit = "m", min = -FAR, max = FAR)
    private double z;
    @Param(doc = "rotation about the x axis", unit = "deg", min = -TURNS, max = TURNS)
    private double rx;
    @Param(doc = "rotation about the y axis, counter-clockwise seen from above", unit = "deg", min = -TURNS, max = TURNS)
    private double ry;
    @Param(doc = "rotation about the z axis", unit = "deg", min = -TURNS, max = TURNS)
    private double rz;

    private enum Life { BEING_MADE, LIVE, READ }

    private Life life;
    private SEARrobot robot;
    private SearObject mover;
    /** Whether its file lies in a folder of its robot's own, because another robot's part of that name has the plain place. */
    private boolean aside;
    private String fullName;
    /** How many simulations had begun when it was made. */
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
     * Has to be the last call of each public constructor: checks all values, then writes the file.
     *
     * @param constructed the class that the constructor belongs to, so that a subclass's constructor can go on
     * @throws IllegalArgumentException with everything that is wrong; nothing is written then
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
        crossCheck((element, value, legal) -> problems.add(element + " is " + ParameterTable.quote(value) + ", legal: " + legal));
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

    /** Adds what is wrong with the values together, beyond the legal range of each. Called when it is created and when it was read. */
    protected void crossCheck(Faults faults) {
    }

    /**
     * Writes the file again.
     *
     * @throws UncheckedIOException if it can't be written; the old file is whole then
     * @throws IllegalStateException if the project does not have it any more
     */
    protected final void changed() {
        if (life == Life.LIVE) {
            rewrite();
            tell("changed", "");
        }
    }

    /** Writes its file, whether there is one or not. */
    final void write() {
        try {
            save();
        } catch (IOException e) {
            throw new UncheckedIOException(label() + " could not be written: " + e.getMessage(), e);
        }
    }

    /** What the project does not have any more must not come back by its old name beside what it is now. */
    private void rewrite() {
        try {
            if (!isKept()) {
                throw new IllegalStateException(label() + " is not in the project any more: it was deleted or renamed there, or another project was"
                    + " opened, since this object was made; sear.edit({\"do\": \"set\", ...}) changes what the project has now, by its name");
            }
            save();
        } catch (IOException e) {
            throw new UncheckedIOException(label() + " could not be written: " + e.getMessage(), e);
        }
    }

    private void moved() {
        if (life == Life.LIVE) {
            rewrite();
            tell("moved", "; sear.edit({\"do\": \"set\", ...}) moves it at once");
        }
    }

    private void tell(String what, String instead) {
        if (!ObjectStores.isRedirected()) {
            Notices.changed(label(), what, instead, starts);
        }
    }

    /** Whether its file is there. */
    boolean isKept() throws IOException {
        return ObjectStores.get().keeps(getFileName(), isRobotPart());
    }

    /** Writes this object's file. */
    void save() throws IOException {
        ObjectStores.get().write(this, isRobotPart());
    }

    /** Whether the file lies in {@code robot/} even before the object is added to a robot. */
    boolean isRobotPart() {
        return robot != null;
    }

    /**
     * A value that may be assigned.
     *
     * @throws IllegalArgumentException that names object, parameter, value and legal range
     */
    protected final double checked(String parameter, double value) {
        check(parameter, value);
        return value + 0.0;
    }

    /**
     * A value that may be assigned.
     *
     * @throws IllegalArgumentException that names object, parameter, value and legal values
     */
    protected final int checked(String parameter, int value) {
        check(parameter, value);
        return value;
    }

    /**
     * A value that may be assigned.
     *
     * @throws IllegalArgumentException that names object, parameter, value and legal form
     */
    protected final String checked(String parameter, String value) {
        check(parameter, value);
        return value;
    }

    /**
     * A value that may be assigned.
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
            throw new IllegalArgumentException(label() + ": " + parameter + " is " + ParameterTable.quote(value) + ", legal: " + described.legal());
        }
    }

    /** Why this kind of object has a parameter that is never set, and what to do instead; null if it may be set. */
    String whyFixed(String parameter) {
        return null;
    }

    /** Why it can't be a component of a robot, after its name, and what is legal; null if it can. */
    String whyNoComponent() {
        return null;
    }

    /** Whether it can steer a wheel. */
    boolean isServo() {
        return false;
    }

    final void checkChangeable() {
        if (life == Life.READ) {
            throw new IllegalStateException(label() + " was read from a project and can't be changed; create objects with their constructors");
        }
    }

    /**
     * Sets parameters by the names that they have in the object's file, for what has no method of its own: {@code box.set({"onGround": False})}. All
     * of them, or, if one is wrong or they don't fit together, none.
     *
     * @param values number, text, True or False by name; None for nothing; a group of parameters is a dictionary in turn, several are a list
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
     * Makes an object of any class of the grammar from its parameters by name, as {@link #set} takes them, whatever constructors the class has.
     *
     * @param type its class
     * @param values what differs from the defaults; the name has to be there
     * @throws IllegalArgumentException with everything that is wrong; nothing is written then
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

    /** Whether a parameter is what an object is called or made of, which no value sets. */
    private static boolean isGiven(Parameter parameter) {
        return parameter.getName().equals("name") || isPart(parameter);
    }

    /**
     * Several parameters were set by name: what hangs on them follows. Called before the file is written.
     *
     * @throws IllegalArgumentException if they don't fit to what else there is
     */
    void valuesSet() {
    }

    /** {@code Box "Box1_name"}. */
    final String label() {
        return getClass().getSimpleName() + " \"" + name + "\"";
    }

    final SEARrobot robot() {
        return robot;
    }

    final void setRobot(SEARrobot newRobot) {
        robot = newRobot;
    }

    /** The motor or servo that turns it; null if there is none, or it was read from a file. */
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

    /** The name, which is also the name of the XML file. */
    public String getName() {
        return name;
    }

    /**
     * The name of the file below {@code environment/} or {@code robot/}, without .xml: the name, or {@code robot/name} for a part that lies in its
     * robot's own folder, because another robot's part has the same name.
     */
    public final String getFileName() {
        return aside ? robot.getName() + "/" + name : name;
    }

    /**
     * What scripts ask for: the name, or {@code robot/name} for a part of whose name another robot of the project has one, too. Only an object that
     * was read with its project knows of the others; for every other it is the name.
     */
    public final String getFullName() {
        return fullName == null ? name : fullName;
    }

    /** Metres. */
    public double getX() {
        return x;
    }

    /** Metres. */
    public double getY() {
        return y;
    }

    /** Metres. */
    public double getZ() {
        return z;
    }

    /** Degrees about x. */
    public double getRx() {
        return rx;
    }

    /** Degrees about y. */
    public double getRy() {
        return ry;
    }

    /** Degrees about z. */
    public double getRz() {
        return rz;
    }

    /** Puts the object there: metres, world frame; body frame once it is a component of a robot. */
    public void move(double newX, double newY, double newZ) {
        double checkedX = checked("x", newX);
        double checkedY = checked("y", newY);
        z = checked("z", newZ);
        x = checkedX;
        y = checkedY;
        moved();
    }

    /** Turns the object: degrees about the three axes, applied as jME's Quaternion.fromAngles. */
    public void rotate(double newRx, double newRy, double newRz) {
        double checkedX = checked("rx", newRx);
        double checkedY = checked("ry", newRy);
        rz = checked("rz", newRz);
        rx = checkedX;
        ry = checkedY;
        moved();
    }

    /** Puts it elsewhere; the values are checked already. */
    final void setPosition(double newX, double newY, double newZ) {
        x = newX + 0.0;
        y = newY + 0.0;
        z = newZ + 0.0;
    }

    /** Sets the pose while the object is being made; {@link #created} checks it. */
    protected final void pose(double newX, double newY, double newZ, double newRx, double newRy, double newRz) {
        x = newX + 0.0;
        y = newY + 0.0;
        z = newZ + 0.0;
        rx = newRx + 0.0;
        ry = newRy + 0.0;
        rz = newRz + 0.0;
    }

    /** {@code Box "Box1_name"}. */
    @Override
    public String toString() {
        return label();
    }
}
