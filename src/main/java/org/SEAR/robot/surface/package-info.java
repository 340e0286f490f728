// SPDX-License-Identifier: Apache-2.0
/**
 * Colours of surfaces for sensors, and appearance of objects to cameras. Uses {@link org.SEAR.camera} and
 * {@link org.SEAR.physics.solid}. Simulation thread.
 */
package org.SEAR.robot.surface;
