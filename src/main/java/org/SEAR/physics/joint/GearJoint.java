// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

/**
 * Gear between two joints: the position of one changes {@code ratio} times as much as that of the other. Acts on the
 * bodies of both joints. Simulation thread.
 */
public final class GearJoint extends Joint {
    private final AxisJoint driven;
    private final AxisJoint driving;
    private final double ratio;
    private final JointedBody[] ends;
    /** Position of the driven joint at position 0 of the driving one, metres or radians. */
    private double offset;

    /** @param ratio of the driven joint's position to that of the driving one, in metres and radians, not 0 */
    public GearJoint(AxisJoint driven, AxisJoint driving, double ratio) {
        super(driven.a(), driven.b());
        this.driven = driven;
        this.driving = driving;
        this.ratio = ratio;
        ends = new JointedBody[] {driven.a(), driven.b(), driving.a(), driving.b()};
    }

    /** Engages the gear at the present positions of both joints, after they have been attached. */
    public void engage() {
        offset = driven.getAxis().getPosition() - ratio * driving.getAxis().getPosition();
    }

    @Override
    JointedBody[] ends() {
        return ends;
    }

    @Override
    int rows() {
        return 1;
    }

    @Override
    void fill(JointRows rows, int at, double seconds) {
        measure(rows, at);
        double error = rows.error[at];
        rows.begin(at);
        driven.fillAxis(rows, at, 1);
        driving.fillAxis(rows, at, -ratio);
        rows.error[at] = error;
    }

    @Override
    void measure(JointRows rows, int at) {
        driven.locate();
        driving.locate();
        rows.error[at] = driven.getAxis().getPosition() - offset - ratio * driving.getAxis().getPosition();
    }

    @Override
    void note(JointRows rows, int at) {
        driven.addAxis(rows.impulse[at]);
        driving.addAxis(-ratio * rows.impulse[at]);
    }

    /** Whether one of its joints has broken. */
    @Override
    public boolean isBroken() {
        return driven.isBroken() || driving.isBroken();
    }
}
