package org.SEAR.view.platform;

import org.lwjgl.glfw.GLFW;
import org.lwjgl.glfw.GLFWJoystickCallback;

/** What jMonkeyEngine 3.6 leaves undone about GLFW, the library that makes its windows. */
public final class Glfw {
    private Glfw() {
    }

    /** jMonkeyEngine places its windows, which Wayland forbids: where there is an X server (XWayland too), take that. Before GLFW starts. */
    public static void preferX11() {
        if (System.getenv("DISPLAY") != null) {
            GLFW.glfwInitHint(GLFW.GLFW_PLATFORM, GLFW.GLFW_PLATFORM_X11);
        }
    }

    /**
     * jMonkeyEngine never takes its joystick callback back; the native side would hold each closed window, with its whole scene, for ever. On the
     * window's thread, before GLFW ends.
     */
    public static void freeLeftovers() {
        GLFWJoystickCallback callback = GLFW.glfwSetJoystickCallback(null);
        if (callback != null) {
            callback.free();
        }
    }
}
