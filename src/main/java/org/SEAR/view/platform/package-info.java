// SPDX-License-Identifier: Apache-2.0
/**
 * Platform differences: availability of a display, GLFW, jMonkeyEngine's version. Uses jMonkeyEngine and LWJGL, and no
 * other package of SEAR. Window thread, except for the display check.
 */
package org.SEAR.view.platform;
