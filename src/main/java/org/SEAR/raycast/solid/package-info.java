/**
 * Where one beam meets one convex solid, one triangle or heights: a class for each kind; and how a model's triangles lie in memory. Uses
 * {@link org.SEAR.geometry} and {@link org.SEAR.raycast.tree}, and what these use. Nothing here allocates. Immutable, for any thread; only
 * {@link org.SEAR.raycast.solid.RayHeights} holds what one thread needs.
 */
package org.SEAR.raycast.solid;
