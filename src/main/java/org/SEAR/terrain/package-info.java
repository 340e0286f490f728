// SPDX-License-Identifier: Apache-2.0
/**
 * Builds the ground of a world from elevation maps: the used area, its position on Earth and its height field. Uses
 * {@link org.SEAR.POJOs}, {@link org.SEAR.terrain.format}, {@link org.SEAR.terrain.relief} and their dependencies. Any
 * thread.
 */
package org.SEAR.terrain;
