/**
 * Pictures without a display: what is on surfaces, the light on them, and cameras' pictures of it by beams. Uses {@link org.SEAR.raycast},
 * {@link org.SEAR.terrain.relief}, {@link org.SEAR.parallel} and {@link org.SEAR.POJOs}, and what these use. A picture is made by the simulation
 * thread, which may have other threads help it; the bytes are the same.
 */
package org.SEAR.camera;
