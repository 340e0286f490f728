// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.ScriptText;
import org.SEAR.grammar.TextRule;

/**
 * A joint of two objects, or of an object and the world. Its pose is that in the world at the start, together with the
 * second object; a lifted object takes its joint along. As a component of a robot it connects two of the robot's
 * shapes, or a shape and the robot's body; its pose is that on the robot.
 */
public abstract class Joint extends SearObject {
    @Param(doc = "name of the first object or robot; without it the second one is joined to the world; in a robot the "
        + "name of one of its shapes, or none for its body", text = TextRule.NAME, names = Shape.class, needed = true)
    private String first;
    @Param(doc = "name of the second object or robot, which moves against the first; in a robot the name of a shape",
        text = TextRule.NAME, required = true, names = Shape.class, needed = true)
    private String second;
    @Param(doc = "in a robot: name of another component that moves with the second: " + MovedParts.LEGAL,
        element = "part", text = TextRule.NAME, names = SearObject.class, maxEntries = MovedParts.MOST)
    private List<String> partNames = new ArrayList<>();
    @Param(doc = "whether both objects collide with each other")
    private boolean collide;
    @Param(doc = "force at which the joint breaks", unit = "N", min = 1e-6, max = 1e9)
    private Double breakingForce;

    /** For reading from a file. */
    protected Joint() {
    }

    /**
     * @param first null for the world
     * @throws IllegalArgumentException if {@code second} is missing
     */
    protected Joint(String name, SearObject first, SearObject second) {
        super(name);
        if (second == null) {
            throw new IllegalArgumentException(getClass().getSimpleName() + " \"" + ScriptText.of(name)
                + "\": the second object is missing (None), legal: an object or robot; None as the first object "
                    + "is the world");
        }
        this.first = first == null ? null : first.getName();
        this.second = second.getName();
    }

    @Override
    protected void crossCheck(Faults faults) {
        if (second != null && second.equals(first)) {
            faults.add("second", second, "another object than the first");
        }
    }

    /** Returns the name of the first object; null for the world. */
    public String getFirst() {
        return first;
    }

    public String getSecond() {
        return second;
    }

    /**
     * Mounts another component of the same robot on the second object of a joint within a robot: it moves along.
     *
     * @param part a shape, a light, a servo, or a sensor except motion sensors and GPS
     * @throws IllegalArgumentException if the part can't be moved, something else moves it, or it is on another robot
     */
    public void mount(SearObject part) {
        checkChangeable();
        MovedParts.add(this, partNames, part);
        changed();
    }

    /** Returns the names of the components that move with the second object; a view. */
    public List<String> getPartNames() {
        return Collections.unmodifiableList(partNames);
    }

    public boolean isCollide() {
        return collide;
    }

    /** @param on whether both objects collide with each other; they don't by default */
    public void setCollide(boolean on) {
        collide = checked("collide", on);
        changed();
    }

    /** Returns newtons; null if it never breaks. */
    public Double getBreakingForce() {
        return breakingForce;
    }

    /** @param newtons force at which the joint breaks */
    public void setBreakingForce(double newtons) {
        breakingForce = checked("breakingForce", newtons);
        changed();
    }
}
