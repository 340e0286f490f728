/**
 * Bodies, their contacts and what solves them. Uses {@link org.SEAR.physics.solid}, and what that uses. Simulation thread.
 *
 * <p>The way of a step ({@link PhysicsWorld#step}): {@code BroadPhase} finds pairs, {@code NarrowPhase} fills the manifolds of each
 * {@code PairContacts}, {@code Islands} parts the bodies, {@code IslandSolver} moves each island in substeps by the rows of its manifolds
 * ({@code ContactRows}, {@code FrictionRows}), {@code Impacts} (what bounces) and {@code AngularState} (what turns
 * freely), and {@code SleepTimer} says what
 * may sleep.
 */
package org.SEAR.physics;
