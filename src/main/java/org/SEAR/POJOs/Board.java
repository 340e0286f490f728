// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Param;

/**
 * A vertical plate with a picture on its front. The front faces -z, towards robots that drive ahead, and its middle is
 * the origin.
 */
public abstract class Board extends Shape {
    /** Default thickness, metres. */
    private static final double THIN = 0.003;

    @Param(doc = "size along z, behind the picture", unit = "m", min = SMALL, max = 100)
    private double thickness = THIN;

    /** For reading from a file. */
    protected Board() {
    }

    /** @param mass kg, 0 fixes it in place */
    protected Board(String name, double mass) {
        super(name, mass);
    }

    /** Returns the size along x, metres, before scaling. */
    public abstract double getBoardWidth();

    /** Returns the size along y, metres, before scaling. */
    public abstract double getBoardHeight();

    public final double getThickness() {
        return thickness;
    }

    /** @param metres size along z, behind the picture, 0.0001 to 100 */
    public final void setThickness(double metres) {
        thickness = checked("thickness", metres);
        changed();
    }

    @Override
    protected String defaultColor() {
        return "#ffffff";
    }
}
