/**
 * What window and tab draw, computed once for both: the scene at one moment, the beams of its sensors, the words of their readings, the colours of
 * lights. Uses {@link org.SEAR.simulator}, and what that uses. Any thread; what it hands out is immutable.
 */
package org.SEAR.scene;
