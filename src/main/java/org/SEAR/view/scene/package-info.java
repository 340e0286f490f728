/**
 * What is to be seen in space: objects, robots, beams, the shapes of the physics, light and ground, and the camera. Uses {@link org.SEAR.scene},
 * and what that uses. What a shape looks like it asks of {@link org.SEAR.physics.solid}. On the window's thread only.
 */
package org.SEAR.view.scene;
