/**
 * Files of elevation maps: SRTM tiles, GeoTIFF, ASCII grids and grey pictures. Nothing in a file is believed before it is checked. Uses
 * {@link org.SEAR.terrain.tiff}, and what that uses. Any thread.
 */
package org.SEAR.terrain.format;
