package org.SEAR.POJOs;

import org.SEAR.grammar.Param;

/**
 * An upright plate with a picture on its front, which looks to where robots come from that drive ahead: towards -z. The middle of its front is its
 * origin.
 */
public abstract class Board extends Shape {
    /** How thick a plate is unless something else is set, metres. */
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

    /** Size along x, metres, before scaling. */
    public abstract double getBoardWidth();

    /** Size along y, metres, before scaling. */
    public abstract double getBoardHeight();

    /** Size along z, metres, before scaling. */
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
