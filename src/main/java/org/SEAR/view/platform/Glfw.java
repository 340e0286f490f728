// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.platform;

import org.lwjgl.glfw.GLFW;
import org.lwjgl.glfw.GLFWJoystickCallback;

/** Workarounds for jMonkeyEngine 3.6's use of GLFW, its window library. */
public final class Glfw {
    private Glfw() {
    }

    /**
     * Prefers X11 (including XWayland) to Wayland, which forbids placing windows as jMonkeyEngine does. Call before
     * GLFW starts.
     */
    public static void preferX11() {
        if (System.getenv("DISPLAY") != null) {
            GLFW.glfwInitHint(GLFW.GLFW_PLATFORM, GLFW.GLFW_PLATFORM_X11);
        }
    }

    /**
     * Frees the joystick callback, which jMonkeyEngine leaves registered. Otherwise the native side would keep each
     * closed window with its whole scene. Window thread, before GLFW ends.
     */
    public static void freeLeftovers() {
        GLFWJoystickCallback callback = GLFW.glfwSetJoystickCallback(null);
        if (callback != null) {
            callback.free();
        }
    }
}
