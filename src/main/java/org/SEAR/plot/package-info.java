/**
 * Plots as picture files: numbers over numbers, axes with titles and units, PNG and SVG. Uses nothing but the JDK. No threads of its own.
 */
package org.SEAR.plot;
