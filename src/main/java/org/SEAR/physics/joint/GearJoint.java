// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

/** Gear: the position of one joint follows that of another, at a ratio. Simulation thread. */
public final class GearJoint extends Joint {
    private final AxisJoint driver;
    private final AxisJoint follower;
    private final double ratio;

    /**
     * @param driver joint whose position sets the other's
     * @param ratio position of the follower per position of the driver
     */
    public GearJoint(String name, AxisJoint driver, AxisJoint follower, double ratio) {
        super(name, driver.b(), follower.b(), driver.a(), driver.b(), follower.a(), follower.b());
        this.driver = driver;
        this.follower = follower;
        this.ratio = ratio;
    }

    @Override
    int rows() {
        return 1;
    }

    @Override
    void fill(JointRows rows, int at, double seconds) {
        rows.begin(at);
        follower.fillAxis(rows, at, 1);
        driver.fillAxis(rows, at, -ratio);
        measure(rows, at);
    }

    @Override
    void measure(JointRows rows, int at) {
        rows.error[at] = follower.getAxis().getPosition() - ratio * driver.getAxis().getPosition();
    }

    @Override
    public boolean isBroken() {
        return super.isBroken() || driver.isBroken() || follower.isBroken();
    }
}
