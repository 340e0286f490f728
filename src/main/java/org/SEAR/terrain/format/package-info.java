/**
 * Files of elevation maps: SRTM tiles, GeoTIFF, ASCII grids and grey pictures. Nothing in a file is believed before it is checked. May use
 * {@link org.SEAR.terrain.tiff} and {@link org.SEAR.files}. Any thread.
 */
package org.SEAR.terrain.format;
