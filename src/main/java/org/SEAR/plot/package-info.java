/**
 * Drawings as picture files, PNG and SVG; plots: numbers over numbers, axes with titles and units. Uses nothing but the JDK. No threads of its own.
 */
package org.SEAR.plot;
