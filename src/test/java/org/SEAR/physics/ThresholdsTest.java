// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.POJOs.Robots;
import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Bodies slide and tip over at the limits of closed forms: slopes within 0.1 degrees, forces within 1 %. */
@Category(Slow.class)
public class ThresholdsTest {
    /** Directions of the slope or push in the frame of the base, degrees. */
    private static final double[] YAWS = {0, 13, 30, 45};

    private final Findings findings = new Findings();

    @Test
    public void bodiesPlacedOnASlopeTipOverFromTheirAngleOn() throws Exception {
        for (ThresholdScenes.Kind kind : ThresholdScenes.Kind.values()) {
            for (double yaw : YAWS) {
                ThresholdScenes.tip(kind, yaw, false, findings);
            }
            ThresholdScenes.tip(kind, YAWS[1], true, findings);
        }
        findings.assertHold();
    }

    @Test
    public void bodiesPlacedOnASlopeSlideFromTheirFrictionAngleOn() throws Exception {
        for (ThresholdScenes.Kind kind : ThresholdScenes.Kind.values()) {
            ThresholdScenes.slide(kind, false, findings);
            ThresholdScenes.slide(kind, true, findings);
        }
        findings.assertHold();
    }

    @Test
    public void aGrowingPushTipsOrMovesThem() throws Exception {
        for (ThresholdScenes.Kind kind : ThresholdScenes.Kind.values()) {
            for (double yaw : YAWS) {
                ThresholdScenes.push(kind, yaw, findings);
            }
        }
        findings.assertHold();
    }

    @Test
    public void breakingAwayAddsNoSpeed() throws Exception {
        for (ThresholdScenes.Kind kind : ThresholdScenes.Kind.values()) {
            ThresholdScenes.breakAway(kind, findings);
        }
        findings.assertHold();
    }

    @Test
    public void robotsTipOverAndSlideUnderAGrowingPush() throws Exception {
        ThresholdScenes.robot(Robots::rover, "rover", 0, 1, 29.96, 0.05 / 0.0867, findings);
        ThresholdScenes.robot(Robots::fourWheeled, "fourWheeled", 0, -1, 42.92, 0.06 / 0.1075, findings);
        ThresholdScenes.robot(Robots::car, "car", 1, 0, 53.89, 0.03 / (8 * 0.01) / 0.0875, findings);
        ThresholdScenes.slide(Robots::car, "car", 1, 0, findings);
        ThresholdScenes.slide(Robots::fourWheeled, "fourWheeled", 0, 1, findings);
        findings.assertHold();
    }
}
