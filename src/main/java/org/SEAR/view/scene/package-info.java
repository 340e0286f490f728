/**
 * What is to be seen in space: objects, robots, beams, the shapes of the physics, light and ground, and the camera. May use
 * {@link org.SEAR.view.link} and below; what a shape looks like it asks of {@link org.SEAR.physics.solid}. On the window's thread only.
 */
package org.SEAR.view.scene;
