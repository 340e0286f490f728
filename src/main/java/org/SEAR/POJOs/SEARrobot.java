// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.ScriptText;
import org.SEAR.grammar.TextRule;

/**
 * A robot: components and wheels, without a shape of its own. It starts at the pose of its {@link Dynamics}, relative
 * to the robot's own pose; that is the world's origin until {@link #move} or {@link #rotate} change it. The robot's XML
 * file in {@code robot/} contains the wheels and the names of the components. Each component has its own file beside it
 * or in the folder {@code robot/ROBOT/}.
 */
@Described("a robot: its wheels, and the names of its components; its pose moves the start pose of its Dynamics")
public class SEARrobot extends PlacedObject {
    private static final int MAX_COMPONENTS = 1000;
    private static final int MAX_WHEELS = 100;
    private static final double MAX_ORDER = 1e9;

    @Param(doc = "heading on the ground, clockwise from north; otherwise the robot's and its Dynamics' rotations count",
        unit = "deg", min = -TURNS, max = TURNS)
    private Double placeHeading;
    @Param(doc = "position in the order of the project's robots; robots without it come first, by name", min = 1,
        max = MAX_ORDER)
    private Integer order;
    @Param(doc = "name of the machine that it is a part of; robots of one machine do not collide with each other",
        text = TextRule.NAME)
    private String machine;
    @Param(doc = "name of a component with a file beside this one; ROBOT/NAME for a file in robot/ROBOT/, if another "
        + "robot has a component of that name", element = "component", text = TextRule.COMPONENT,
        maxEntries = MAX_COMPONENTS)
    private List<String> componentNames = new ArrayList<>();
    @Param(doc = "a wheel", element = "wheel", maxEntries = MAX_WHEELS)
    private List<Wheel> wheels = new ArrayList<>();
    private final List<SearObject> components = new ArrayList<>();

    /** For reading from a file. */
    protected SEARrobot() {
    }

    /**
     * Creates a robot without parts, the last in the order of the project's robots. It replaces a robot of the same
     * name.
     */
    public SEARrobot(String name) {
        super(name);
        order = TextRule.NAME.isLegal(getName()) ? ObjectStores.get().orderOfRobot(getName()) : null;
        created(SEARrobot.class);
        if (!ObjectStores.isRedirected()) {
            ScriptSessions.ALL.made(this);
        }
    }

    @Override
    boolean isRobotPart() {
        return true;
    }

    @Override
    String whyNoComponent() {
        return " can't be a component, legal: a shape, a model, a sensor, dynamics";
    }

    /**
     * Returns the heading on the ground, degrees clockwise from north; null if the rotations of the robot and its
     * Dynamics define it.
     */
    public Double getPlaceHeading() {
        return placeHeading;
    }

    /**
     * Places the robot on the ground at a geographic position with a heading, whatever the pose of its Dynamics.
     *
     * @param latitude degrees, north positive
     * @param longitude degrees, east positive
     * @param heading degrees clockwise from north
     */
    public void place(double latitude, double longitude, double heading) {
        double checkedHeading = checked("placeHeading", heading);
        place(latitude, longitude);
        placeHeading = checkedHeading;
        changed();
    }

    /**
     * Places the robot on the ground at a point of the world with a heading, whatever the pose of its Dynamics.
     *
     * @param newX metres north of the world's origin
     * @param newZ metres east of it
     * @param heading degrees clockwise from north
     */
    public void placeAt(double newX, double newZ, double heading) {
        double checkedHeading = checked("placeHeading", heading);
        placeAt(newX, newZ);
        placeHeading = checkedHeading;
        changed();
    }

    @Override
    public void move(double newX, double newY, double newZ) {
        super.move(newX, newY, newZ);
        turnAsWritten();
    }

    @Override
    public void rotate(double newRx, double newRy, double newRz) {
        super.rotate(newRx, newRy, newRz);
        turnAsWritten();
    }

    private void turnAsWritten() {
        if (placeHeading != null) {
            placeHeading = null;
            changed();
        }
    }

    /**
     * Adds a component: its pose becomes relative to the body frame, and its XML file moves to {@code robot/}. If an
     * earlier robot has a part of that name, that part's file moves on to {@code robot/ROBOT/}.
     *
     * @param component a shape, a sensor or the dynamics, not null
     * @throws IllegalArgumentException if the component is already a part, a robot, a wheel (see {@link #addWheel}), or
     *     has the name of another part
     */
    public void addComponent(SearObject component) {
        checkChangeable();
        checkPart(component, "a component");
        if (component.whyNoComponent() != null) {
            throw new IllegalArgumentException(label() + ": " + component.label() + component.whyNoComponent());
        }
        if (component instanceof Dynamics && components.stream().anyMatch(c -> c instanceof Dynamics)) {
            throw new IllegalArgumentException(label() + ": " + component.label()
                + " would be its second Dynamics, legal: one");
        }
        if (components.size() >= MAX_COMPONENTS) {
            throw new IllegalArgumentException(label() + ": component is " + component.label() + ", legal: at most "
                + MAX_COMPONENTS + " components");
        }
        adopt(component);
    }

    private void adopt(SearObject component) {
        boolean wasPart = component.isRobotPart();
        component.setRobot(this);
        components.add(component);
        componentNames.add(component.getFileName());
        boolean done = false;
        try {
            component.write();
            changed();
            done = true;
        } finally {
            if (!done) {
                component.setRobot(null);
                components.remove(component);
                componentNames.remove(component.getName());
            }
        }
        if (!wasPart) {
            removeFile(component.getName(), false);
        }
        removeFile(asideName(component), true);
    }

    private String asideName(SearObject component) {
        return getName() + "/" + component.getName();
    }

    /**
     * Moves a component's file into this robot's own folder. The project is consistent after each step, so a failure
     * loses nothing.
     *
     * @throws IllegalArgumentException if the two names are too long for a file
     */
    void moveAside(SearObject component) throws IOException {
        checkAside(component.getName());
        setAside(component, true);
        boolean done = false;
        try {
            component.save();
            save();
            done = true;
        } finally {
            if (!done) {
                setAside(component, false);
                ObjectStores.get().remove(asideName(component), true);
            }
        }
        ObjectStores.get().remove(component.getName(), true);
    }

    private void checkAside(String component) {
        String aside = getName() + "/" + component;
        if (!TextRule.COMPONENT.isLegal(aside)) {
            throw new IllegalArgumentException(label() + ": another robot's part is also named "
                + ParameterTable.quote(component) + ", legal: names short enough for \"" + aside
                    + "\" (190 characters), or a unique name");
        }
    }

    /** Names a component of a robot that was read as a file in the robot's own folder, and returns that name. */
    String nameAside(String component) {
        checkAside(component);
        String aside = getName() + "/" + component;
        componentNames.set(componentNames.indexOf(component), aside);
        return aside;
    }

    void forgetAside(SearObject component) {
        setAside(component, false);
    }

    /**
     * Chooses between {@code robot/ROBOT/NAME.xml} and {@code robot/NAME.xml} for a component's file. Scripts need it
     * only to reproduce files; otherwise a file moves by itself when another robot gets a part of the same name.
     *
     * @param component name of a component of this robot
     * @param on whether the file lies in the robot's own folder
     * @throws IllegalArgumentException if there is no such component
     */
    public void setOwnFolder(String component, boolean on) {
        checkChangeable();
        String wanted = ScriptText.of(component);
        SearObject part = components.stream().filter(c -> c.getName().equals(wanted)).findFirst()
            .orElseThrow(() -> new IllegalArgumentException(
            label() + ": component is " + ParameterTable.quote(wanted) + ", legal: " + components.stream()
            .map(SearObject::getName).collect(Collectors.joining(", "))));
        boolean aside = !part.getFileName().equals(part.getName());
        if (aside == on) {
            return;
        }
        try {
            if (on) {
                moveAside(part);
            } else {
                setAside(part, false);
                part.save();
                save();
                ObjectStores.get().remove(asideName(part), true);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(part.label() + " could not be moved: " + e.getMessage(), e);
        }
    }

    private void setAside(SearObject component, boolean aside) {
        component.setAside(aside);
        componentNames.set(components.indexOf(component), component.getFileName());
    }

    /**
     * Adds a wheel; the robot's file then contains it.
     *
     * @throws IllegalArgumentException if the wheel is already a part, or has the name of another part
     */
    public void addWheel(Wheel wheel) {
        checkChangeable();
        checkPart(wheel, "a wheel");
        if (wheels.size() >= MAX_WHEELS) {
            throw new IllegalArgumentException(label() + ": wheel is " + wheel.label() + ", legal: at most "
                + MAX_WHEELS + " wheels");
        }
        wheel.setRobot(this);
        wheels.add(wheel);
        boolean done = false;
        try {
            changed();
            done = true;
        } finally {
            if (!done) {
                wheel.setRobot(null);
                wheels.remove(wheel);
            }
        }
        try {
            ObjectStores.get().removeOwn(wheel);
        } catch (IOException e) {
            throw notRemoved(wheel.getName(), e);
        }
    }

    private void removeFile(String name, boolean part) {
        try {
            ObjectStores.get().remove(name, part);
        } catch (IOException e) {
            throw notRemoved(name, e);
        }
    }

    private UncheckedIOException notRemoved(String name, IOException e) {
        return new UncheckedIOException(label() + ": the old file of \"" + name + "\" could not be removed: "
            + e.getMessage(), e);
    }

    private void checkPart(SearObject part, String what) {
        if (part == null) {
            throw new IllegalArgumentException(label() + ": " + what + " is null, legal: an object");
        }
        if (part.robot() != null) {
            throw new IllegalArgumentException(label() + ": " + part.label() + " is already a part of "
                + part.robot().label() + ", legal: an object that isn't part of a robot");
        }
        part.checkChangeable();
        List<String> names = components.stream().map(SearObject::getName).collect(Collectors.toList());
        names.addAll(wheels.stream().map(SearObject::getName).collect(Collectors.toList()));
        names.add(getName());
        for (String taken : names) {
            if (taken.equalsIgnoreCase(part.getName())) {
                throw new IllegalArgumentException(label() + ": " + part.label() + " has the name of another part, "
                    + "legal: a name that differs from " + names + " by more than capitals");
            }
        }
    }

    /** Adds a component that was read from its own file. */
    void link(SearObject component, boolean aside) {
        component.setRobot(this);
        component.setAside(aside);
        components.add(component);
    }

    /** Returns the components in the order of their addition; a view. */
    public List<SearObject> getComponents() {
        return Collections.unmodifiableList(components);
    }

    /** Returns whether the open project contains the robot's file. */
    boolean isInProject() {
        try {
            return ObjectStores.get().replaces(getName());
        } catch (IOException e) {
            throw new UncheckedIOException("the project can't be read: " + e.getMessage(), e);
        }
    }

    /**
     * Returns a component or wheel by its name, for example a motor of a ready robot.
     *
     * @throws IllegalArgumentException with the names of the robot's parts, if it has none of that name
     */
    public SearObject getPart(String part) {
        String wanted = ScriptText.of(part);
        return Stream.concat(components.stream(), wheels.stream()).filter(one -> one.getName().equals(wanted))
            .findFirst()
            .orElseThrow(() -> new IllegalArgumentException(label() + ": part is " + ParameterTable.quote(wanted)
                + ", legal: " + Stream.concat(components.stream(), wheels.stream()).map(SearObject::getName)
                    .collect(Collectors.joining(", "))));
    }

    /**
     * Returns the robot's position in the order of the project's robots; null for the first robot, and in files of
     * older versions.
     */
    public Integer getOrder() {
        return order;
    }

    /** Returns the components' files (see {@link SearObject#getFileName}) in the order of their addition; a view. */
    public List<String> getComponentNames() {
        return Collections.unmodifiableList(componentNames);
    }

    /** Returns the name of the machine that it is a part of; null for none. */
    public String getMachine() {
        return machine;
    }

    /** @param newMachine name shared by robots that do not collide with each other; null for none */
    public void setMachine(String newMachine) {
        machine = checked("machine", newMachine);
        changed();
    }

    /** Returns the wheels in the order of their addition; a view. */
    public List<Wheel> getWheels() {
        return Collections.unmodifiableList(wheels);
    }
}
