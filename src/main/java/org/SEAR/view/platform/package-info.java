/**
 * What differs between computers: whether there is a display, GLFW, X11's errors, native memory. Uses no other package of SEAR. It needs
 * jMonkeyEngine, LWJGL and JNA. On the window's thread, but for the question whether there is a display.
 */
package org.SEAR.view.platform;
