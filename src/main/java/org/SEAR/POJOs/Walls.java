// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;

/** Vertical walls of one height from a drawing. They are fixed and stand on their origin's height. */
public abstract class Walls extends Shape {
    /** Greatest height of walls, metres. */
    private static final double HIGHEST = 100;
    private static final String FIXED = "walls are fixed";

    @Param(doc = "height of the walls above their origin", unit = "m", min = SMALL, max = HIGHEST)
    private double height;

    /**
     * For reading from a file.
     *
     * @param height default, metres
     */
    protected Walls(double height) {
        this.height = height;
    }

    /** @param height metres */
    protected Walls(String name, double height) {
        super(name, 0);
        this.height = height;
    }

    public final double getHeight() {
        return height;
    }

    /** @param metres height of the walls, 0.0001 to 100 */
    public final void setHeight(double metres) {
        height = checked("height", metres);
        changed();
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (getMass() != 0) {
            faults.add("mass", Parameter.format(getMass()), "0: " + FIXED);
        }
    }

    @Override
    String whyFixed(String parameter) {
        return parameter.equals("mass") || Shape.isLaunching(parameter) ? FIXED : null;
    }

    @Override
    String whyNoComponent() {
        return " has fixed walls and can't be a component";
    }

    @Override
    protected String defaultColor() {
        return "#d8d4cc";
    }
}
