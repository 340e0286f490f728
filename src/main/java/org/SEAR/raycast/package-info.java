/**
 * What beams meet: shapes and triangle meshes in hierarchies, and the walks of rays, fans and bundles through them. Uses
 * {@link org.SEAR.raycast.solid}, and what it uses. The simulation thread builds and moves; between two commits
 * any number of threads may cast.
 */
package org.SEAR.raycast;
