// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Vec3;

/** Shape and direction of one wheel for its contact with the ground. Simulation thread. */
final class WheelShape {
    /** Scaled radius, and half of the scaled width, metres. */
    final double radius;
    final double half;
    /** Whether it is a ball: an idler without a trail rolls in every direction. */
    final boolean ball;
    /** Direction in which it rolls, world frame. */
    final Vec3 ahead = new Vec3();

    WheelShape(Wheel wheel) {
        radius = wheel.getRadius() * wheel.getScaleY();
        half = wheel.getWidth() / 2 * wheel.getScaleX();
        ball = wheel.getType() == Wheel.IDLER && wheel.getTrail() == 0;
    }
}
