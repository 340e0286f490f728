/**
 * The three-dimensional scene: objects, robots, beams, physics shapes, light, shadows and the camera. Uses
 * {@link org.SEAR.scene}, {@link org.SEAR.physics.solid} for the surfaces of shapes, and their dependencies. Window
 * thread only.
 */
package org.SEAR.view.scene;
