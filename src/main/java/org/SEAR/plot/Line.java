// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

/** One line of a plot. Immutable except for its array. */
final class Line {
    final String name;
    /** Empty for none. */
    final String unit;
    /** As many as the plot's axis has positions; NaN leaves a gap. */
    final double[] values;

    Line(String name, String unit, double[] values) {
        this.name = name;
        this.unit = unit;
        this.values = values;
    }
}
