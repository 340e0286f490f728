package org.SEAR.plot;

/** One line of a plot. Immutable but for its array. */
final class Line {
    final String name;
    /** Empty for none. */
    final String unit;
    /** As many as the plot has places along its axis; not a number where the line has a gap. */
    final double[] values;

    Line(String name, String unit, double[] values) {
        this.name = name;
        this.unit = unit;
        this.values = values;
    }
}
