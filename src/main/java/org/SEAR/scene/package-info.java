// SPDX-License-Identifier: Apache-2.0
/**
 * Drawing data that the window and the tab share: interpolation between steps, sensor beams, camera cones, text of
 * readings, colours of lights. Uses {@link org.SEAR.simulator} and its dependencies. Any thread;
 * returned objects are immutable.
 *
 * <p>The tab interpolates between two messages itself. Its poses ({@code shared/geometry.js}) follow
 * {@link org.SEAR.geometry.Pose} and {@link org.SEAR.scene.Movement#between}; a browser test compares the numbers. The
 * display delay differs: two steps in the window, which gets each step, and the time between two messages in the tab.
 */
package org.SEAR.scene;
