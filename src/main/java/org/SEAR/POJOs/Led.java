// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.List;
import org.SEAR.grammar.ColorNames;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;
import org.SEAR.protocol.arduino.WireRole;

/**
 * A light-emitting diode on a robot, which scripts and the pin of an Arduino switch and dim. It has no mass, and
 * sensors do not see it.
 */
@Described("a light-emitting diode on a robot; scripts and the pin of an Arduino switch and dim it; sensors "
    + "do not see it")
public class Led extends SearObject implements Wirable {
    private static final String RED = "#ff0000";
    private static final double SIZE = 0.01;

    @Param(doc = "colour of its light; default red", text = TextRule.COLOR)
    private String color;
    @Param(doc = "diameter", unit = "m", min = 0.001, max = 1)
    private double size = SIZE;

    /** For reading from a file. */
    protected Led() {
    }

    /** Red, 1 cm wide, at the robot's origin. */
    public Led(String name) {
        this(name, 0, 0, 0);
    }

    /** Red, at (x, y, z) of the body frame, metres. */
    public Led(String name, double x, double y, double z) {
        this(name, null, x, y, z);
    }

    /**
     * At (x, y, z) of the body frame, metres.
     *
     * @param color {@code #rrggbb}, or a name such as red, green, blue; null for red
     */
    public Led(String name, String color, double x, double y, double z) {
        super(name);
        this.color = color;
        pose(x, y, z, 0, 0, 0);
        created(Led.class);
    }

    @Override
    boolean isRobotPart() {
        return true;
    }

    @Override
    public List<WireRole> getWireRoles() {
        return List.of(WireRole.LIGHT);
    }

    /** Returns the colour as {@code #rrggbb}. */
    public String getColor() {
        return color == null ? RED : ColorNames.hex(color);
    }

    public double getSize() {
        return size;
    }

    /** @param newColor {@code #rrggbb}, or a name such as red, green, blue; null for red */
    public void setColor(String newColor) {
        color = checked("color", newColor);
        changed();
    }

    /** @param metres diameter, 0.001 to 1 */
    public void setSize(double metres) {
        size = checked("size", metres);
        changed();
    }
}
