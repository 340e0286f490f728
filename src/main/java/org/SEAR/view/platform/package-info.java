/**
 * What differs between computers: whether there is a display, GLFW, X11's errors, native memory. Uses jMonkeyEngine, LWJGL and JNA, and nothing of
 * SEAR. On the window's thread, but for the question whether there is a display.
 */
package org.SEAR.view.platform;
