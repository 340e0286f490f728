// SPDX-License-Identifier: Apache-2.0
/**
 * Elevation map formats: SRTM tiles, GeoTIFF, ASCII grids and grey pictures. Every value of a file is checked before
 * use. Uses {@link org.SEAR.terrain.tiff} and its dependencies. Any thread.
 */
package org.SEAR.terrain.format;
