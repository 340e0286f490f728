// SPDX-License-Identifier: Apache-2.0
/**
 * Joints: hinges, sliders, balls and distances between bodies, with motors, limits, friction and springs. A
 * {@link org.SEAR.physics.joint.Mechanism} solves all joints of connected bodies together. Uses
 * {@link org.SEAR.geometry}.
 */
package org.SEAR.physics.joint;
