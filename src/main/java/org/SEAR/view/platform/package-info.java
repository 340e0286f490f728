/**
 * Platform differences: availability of a display, GLFW, X11 errors, native memory. Depends on jMonkeyEngine, LWJGL and
 * JNA, and on no other package of SEAR. Window thread, except for the display check.
 */
package org.SEAR.view.platform;
