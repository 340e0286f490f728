/**
 * Poses, rotations, frames, triangles and heights of the ground, the world's place on Earth, and the length of a step. Uses no other package of
 * SEAR. Immutable classes serve any thread, the mutable ones the thread that made them.
 */
package org.SEAR.geometry;
