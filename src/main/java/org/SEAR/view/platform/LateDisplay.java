// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.platform;

import com.jme3.system.lwjgl.LwjglDisplay;
import org.lwjgl.glfw.GLFW;

/** Window of jMonkeyEngine that appears with its first picture instead of black. */
public final class LateDisplay extends LwjglDisplay {
    @Override
    protected void showWindow() {
        // show() does this later
    }

    /** Shows the window. Window thread. */
    public void show() {
        GLFW.glfwShowWindow(getWindowHandle());
    }
}
