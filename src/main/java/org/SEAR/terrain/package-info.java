/**
 * From elevation maps to the ground of a world: the area that is used, its place on Earth, its height field. Uses {@link org.SEAR.POJOs},
 * {@link org.SEAR.terrain.format} and {@link org.SEAR.terrain.relief}, and what these use. Any thread.
 */
package org.SEAR.terrain;
