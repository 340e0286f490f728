// SPDX-License-Identifier: Apache-2.0
/**
 * Platform differences: availability of a display, GLFW, X11 errors, native memory. Uses jMonkeyEngine, LWJGL and
 * JNA, and no other package of SEAR. Window thread, except for the display check.
 */
package org.SEAR.view.platform;
