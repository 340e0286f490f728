/**
 * What an object of the grammar is to touch, to beams and to whoever draws it: its geometry, its surface, and its triangles, which jbullet finds.
 * {@link org.SEAR.physics.solid.Solids} lists the kinds. Uses {@link org.SEAR.collision}, {@link org.SEAR.project} and {@link org.SEAR.raycast}, and
 * what these use. Made on the thread that opens a project, then used by the simulation thread.
 */
package org.SEAR.physics.solid;
