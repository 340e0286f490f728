// SPDX-License-Identifier: Apache-2.0
/**
 * Rigid bodies, their contacts and the contact solver. Uses {@link org.SEAR.physics.joint} and
 * {@link org.SEAR.physics.solid}. Simulation thread.
 *
 * <p>A step ({@link PhysicsWorld#step}): {@code BroadPhase} finds pairs, {@code NarrowPhase} fills the manifolds of
 * each {@code PairContacts}, and {@code Islands} groups the bodies. {@code IslandSolver} moves each island in substeps
 * by the rows of its manifolds ({@code ContactRows}, {@code FrictionRows}), {@code Impacts} (restitution) and
 * {@code AngularState} (free rotation). {@code SleepTimer} decides which bodies may sleep.
 */
package org.SEAR.physics;
