// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Param;

/** A hinge or slider: its axis is fixed in both objects. */
public abstract class GuidedJoint extends AxisJoint {
    private static final double MOST = 1e6;

    @Param(doc = "position at the start, in which its objects are placed; 0 if missing", unit = "deg or m", min = -MOST,
        max = MOST)
    private Double start;

    /** For reading from a file. */
    protected GuidedJoint() {
    }

    /** @param first null for the world */
    protected GuidedJoint(String name, SearObject first, SearObject second) {
        super(name, first, second);
    }

    public double getStart() {
        return start == null ? 0 : start;
    }

    /** @param position of the joint while its objects are where they start, degrees of a hinge, metres of a slider */
    public void setStart(double position) {
        start = checked("start", position);
        changed();
    }
}
