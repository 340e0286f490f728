// SPDX-License-Identifier: Apache-2.0
/**
 * Intersections of rays with convex solids, triangles and height fields, one class per kind, and the memory layout of a
 * model's triangles. Uses {@link org.SEAR.raycast.tree} and its dependencies. Casting allocates nothing. Classes are
 * immutable, any thread, except {@link org.SEAR.raycast.solid.RayHeights} and
 * {@link org.SEAR.raycast.solid.HeightsTile}: one instance per thread.
 */
package org.SEAR.raycast.solid;
