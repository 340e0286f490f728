/**
 * From elevation maps to the ground of a world: the area that is used, its place on Earth, its height field. May use
 * {@link org.SEAR.terrain.format}, {@link org.SEAR.files} and {@link org.SEAR.geometry}. Any thread.
 */
package org.SEAR.terrain;
