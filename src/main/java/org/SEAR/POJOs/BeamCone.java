// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.grammar.ColorNames;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;

/** One cone of a distance sensor's beam: rays from the sensor to the cone's rim. Immutable, any thread. */
@Described("one cone of a beam")
public class BeamCone {
    /** Default number of rays of a cone. */
    public static final int DEFAULT_LINES = 36;
    /** Largest number of rays of a cone. */
    public static final int MAX_LINES = 360;
    private static final String DEFAULT_COLOR = "#ffa500";

    @Param(doc = "angle between axis and rim; 0 is a single ray", unit = "deg", max = 90, required = true,
        initial = "15")
    private double halfAngle;
    @Param(doc = "length of each ray", unit = "m", min = 0.001, max = 10000, required = true, initial = "3")
    private double range;
    @Param(doc = "colour of the rays", text = TextRule.COLOR)
    private String color = DEFAULT_COLOR;
    @Param(doc = "number of rays", min = 1, max = MAX_LINES)
    private int lines = DEFAULT_LINES;
    @Param(doc = "direction of the axis to the left of the sensor's, for side lobes", unit = "deg", min = -180,
        max = 180)
    private double yaw;
    @Param(doc = "direction of the axis above the sensor's, for side lobes", unit = "deg", min = -90, max = 90)
    private double pitch;

    /** For reading from a file. */
    protected BeamCone() {
    }

    /**
     * An orange cone of 36 rays.
     *
     * @param halfAngle degrees, 0 to 90
     * @param range metres
     */
    public BeamCone(double halfAngle, double range) {
        this(halfAngle, range, DEFAULT_COLOR);
    }

    /** @param color #rrggbb, or a name as for {@link Shape#setColor} */
    public BeamCone(double halfAngle, double range, String color) {
        this(halfAngle, range, color, DEFAULT_LINES);
    }

    /** @param lines 1 to 360 */
    public BeamCone(double halfAngle, double range, String color, int lines) {
        this(halfAngle, range, color, lines, 0, 0);
    }

    /**
     * With all parameters.
     *
     * @param yaw degrees to the left, for a side lobe
     * @param pitch degrees up, for a side lobe
     * @throws IllegalArgumentException with all problems
     */
    public BeamCone(double halfAngle, double range, String color, int lines, double yaw, double pitch) {
        this.halfAngle = halfAngle;
        this.range = range;
        this.color = color == null ? DEFAULT_COLOR : color;
        this.lines = lines;
        this.yaw = yaw;
        this.pitch = pitch;
        List<String> problems = ParameterTable.of(BeamCone.class).problems(this, "");
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException("BeamCone: " + String.join("; ", problems));
        }
    }

    /**
     * Returns a cone from an entry of a script's list: a BeamCone, or [halfAngle, range, color, lines, yaw, pitch]; all
     * but the first two are optional.
     */
    static BeamCone of(Object entry) {
        if (entry instanceof BeamCone) {
            return (BeamCone) entry;
        }
        if (entry instanceof List && ((List<?>) entry).size() >= 2 && ((List<?>) entry).size() <= 6) {
            List<Object> values = new ArrayList<>((List<?>) entry);
            Object color = values.size() > 2 ? values.remove(2) : null;
            if ((color == null || color instanceof String) && values.stream().allMatch(v -> v instanceof Number)) {
                double[] n = {0, 0, DEFAULT_LINES, 0, 0};
                for (int i = 0; i < values.size(); i++) {
                    n[i] = ((Number) values.get(i)).doubleValue();
                }
                return new BeamCone(n[0], n[1], (String) color, whole(n[2]), n[3], n[4]);
            }
        }
        throw new IllegalArgumentException("cone is " + entry + ", legal: a BeamCone or [half-angle in degrees, range "
            + "in metres, colour, lines, yaw, pitch]; all but the first two are optional");
    }

    private static int whole(double number) {
        if (number != Math.rint(number)) {
            throw new IllegalArgumentException("BeamCone: lines is " + Parameter.format(number)
                + ", legal: a whole number from 1 to " + MAX_LINES);
        }
        return (int) number;
    }

    /** Returns the same cone with another number of rays. */
    BeamCone withLines(int newLines) {
        return new BeamCone(halfAngle, range, color, halfAngle == 0 ? 1 : newLines, yaw, pitch);
    }

    public double getHalfAngle() {
        return halfAngle;
    }

    public double getRange() {
        return range;
    }

    /** Returns the colour as #rrggbb. */
    public String getColor() {
        return ColorNames.hex(color);
    }

    public int getLines() {
        return lines;
    }

    public double getYaw() {
        return yaw;
    }

    public double getPitch() {
        return pitch;
    }
}
