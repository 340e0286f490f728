package org.SEAR.view.platform;

import com.jme3.system.lwjgl.LwjglDisplay;
import org.lwjgl.glfw.GLFW;

/** A window of jMonkeyEngine's that is shown when it has its first picture, and not black before. */
public final class LateDisplay extends LwjglDisplay {
    @Override
    protected void showWindow() {
        // shown later, by show
    }

    /** Asked before each picture: nothing is drawn for an X server that went away. Window thread. */
    @Override
    public boolean isRenderable() {
        return super.isRenderable() && X11Guard.answers();
    }

    /** Shows the window. Window thread. */
    public void show() {
        GLFW.glfwShowWindow(getWindowHandle());
    }
}
