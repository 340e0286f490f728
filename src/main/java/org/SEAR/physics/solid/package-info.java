// SPDX-License-Identifier: Apache-2.0
/**
 * Solids of the grammar's objects for contacts, rays and drawing: geometry, surface, and triangles, which jbullet
 * finds. {@link org.SEAR.physics.solid.Solids} lists the kinds. Uses {@link org.SEAR.collision},
 * {@link org.SEAR.project} and {@link org.SEAR.raycast}. Made on the thread that opens a project, then used by the
 * simulation thread.
 */
package org.SEAR.physics.solid;
