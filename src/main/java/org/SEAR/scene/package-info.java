/**
 * What window and tab draw, computed once for both: the scene at one moment, movement between steps, the beams of its sensors, lines around what
 * cameras see, the words of readings, the colours of lights. Uses {@link org.SEAR.simulator}, and what that uses. Any thread; what it hands out is
 * immutable.
 *
 * <p>What the tab has to compute itself, because it moves things between two messages, follows the rules of this side, and a test in the browser
 * holds it to the same numbers: poses ({@code shared/geometry.js}) as {@link org.SEAR.geometry.Pose}, and the way between two of them as
 * {@link org.SEAR.scene.Movement#between}. They differ in how late they show the world: the window, which gets each step, by two steps, the tab by
 * the time between two messages.
 */
package org.SEAR.scene;
