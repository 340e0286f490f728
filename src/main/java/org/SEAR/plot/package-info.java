/**
 * Drawings as PNG and SVG files, and plots of numbers with axes, titles and units. Uses only the JDK. No threads of its
 * own.
 */
package org.SEAR.plot;
