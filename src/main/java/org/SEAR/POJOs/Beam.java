// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;

/**
 * The beam of a kind of distance sensor, as data: a file {@code beams/NAME.xml} of the project, or a beam that comes
 * with SEAR. Immutable, any thread.
 */
@Described("a named beam, a file in the project's beams folder")
public class Beam {
    private static final int MAX_CONES = 100;
    private static final int MAX_POINTS = 200;

    @Param(doc = "name of the beam and of its file", text = TextRule.NAME, required = true)
    private String name;
    @Param(doc = "other names of the same product", text = TextRule.NAME, maxEntries = 20)
    private List<String> alias = new ArrayList<>();
    @Param(doc = "description")
    private String description;
    @Param(doc = "smallest distance the product reports, also for nearer objects", unit = "m", max = 10000)
    private double minRange;
    @Param(doc = "a cone", maxEntries = MAX_CONES)
    private List<BeamCone> cone = new ArrayList<>();
    @Param(doc = "a point of the curve from distance to output voltage, nearest first", maxEntries = MAX_POINTS)
    private List<VoltagePoint> voltage = new ArrayList<>();

    /** For reading from a file. */
    protected Beam() {
    }

    public String getName() {
        return name;
    }

    /** Returns other names of the same product. */
    public List<String> getAliases() {
        return Collections.unmodifiableList(alias);
    }

    /** Returns the description; null if the file has none. */
    public String getDescription() {
        return description;
    }

    public double getMinRange() {
        return minRange;
    }

    /** Returns the cones, at least one. */
    public List<BeamCone> getCones() {
        return Collections.unmodifiableList(cone);
    }

    /** Returns the curve from distance to output voltage, nearest first; empty for a sensor without one. */
    public List<VoltagePoint> getVoltages() {
        return Collections.unmodifiableList(voltage);
    }
}
