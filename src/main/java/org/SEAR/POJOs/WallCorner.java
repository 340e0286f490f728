// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.List;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.ParameterTable;

/** One corner of a wall. Immutable, any thread. */
@Described("one corner of a wall")
public class WallCorner {
    private static final double FARTHEST = 10_000;

    @Param(doc = "position northwards from the wall's origin", unit = "m", min = -FARTHEST, max = FARTHEST)
    private double x;
    @Param(doc = "position eastwards from the wall's origin", unit = "m", min = -FARTHEST, max = FARTHEST)
    private double z;

    /** For reading from a file. */
    protected WallCorner() {
    }

    /**
     * Metres from the wall's origin.
     *
     * @throws IllegalArgumentException with all problems
     */
    public WallCorner(double x, double z) {
        this.x = x;
        this.z = z;
        List<String> problems = ParameterTable.of(WallCorner.class).problems(this, "");
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException("WallCorner: " + String.join("; ", problems));
        }
    }

    /** Returns a corner, or that of a list of x and z. */
    static WallCorner of(Object entry) {
        if (entry instanceof WallCorner) {
            return (WallCorner) entry;
        }
        if (entry instanceof List && ((List<?>) entry).size() == 2 && ((List<?>) entry).stream()
            .allMatch(Number.class::isInstance)) {
            return new WallCorner(((Number) ((List<?>) entry).get(0)).doubleValue(),
                ((Number) ((List<?>) entry).get(1)).doubleValue());
        }
        throw new IllegalArgumentException("corner is " + ParameterTable.quote(String.valueOf(entry))
            + ", legal: a WallCorner, or (x, z) in metres");
    }

    public double getX() {
        return x;
    }

    public double getZ() {
        return z;
    }
}
