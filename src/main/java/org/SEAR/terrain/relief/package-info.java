/**
 * Pictures of the ground from its heights: slopes, hill shading, colours by height and slope. For the window, which lays one over its terrain, and
 * for maps. Uses {@link org.SEAR.geometry}, and what that uses. Knows neither files nor the window; any thread.
 */
package org.SEAR.terrain.relief;
