// SPDX-License-Identifier: Apache-2.0
/**
 * The three-dimensional scene: objects, robots, beams, physics shapes, light, shadows and the camera. Uses
 * {@link org.SEAR.scene} and its dependencies. Window thread only.
 */
package org.SEAR.view.scene;
