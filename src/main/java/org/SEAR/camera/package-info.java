// SPDX-License-Identifier: Apache-2.0
/**
 * Pictures without a display: textures of surfaces, light, and pictures of cameras by beams. Uses
 * {@link org.SEAR.raycast}, {@link org.SEAR.terrain.relief}, {@link org.SEAR.parallel} and {@link org.SEAR.POJOs}, and
 * what these use. The simulation thread renders a picture, with the help of other threads; the bytes are the same.
 */
package org.SEAR.camera;
