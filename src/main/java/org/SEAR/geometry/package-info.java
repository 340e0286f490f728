// SPDX-License-Identifier: Apache-2.0
/**
 * Poses, rotations, frames, triangles, elevations of the ground, the world's place on Earth, and the length of a step.
 * Uses no other package of SEAR. Immutable classes are safe on any thread, mutable ones on the thread that made them.
 */
package org.SEAR.geometry;
