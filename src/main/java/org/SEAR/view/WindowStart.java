// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import com.jme3.system.AppSettings;
import org.SEAR.view.link.WorldLink;

/** Opens a window in this process. */
final class WindowStart {
    /** GLFW's error message for an X server that doesn't respond. */
    private static final String NO_SERVER = "Failed to open display";

    private WindowStart() {
    }

    /**
     * Opens a window with OpenGL 3.2 or, on an old machine, 2.0. Returns when the window shows its first picture. On
     * macOS, where it runs on the caller's thread, returns after the window has closed.
     * @param onShown called on the window's thread after the first picture
     * @return the last window tried; check its problem
     */
    static WindowApplication open(WorldLink link, WindowOptions options, Runnable onShown) throws InterruptedException {
        WindowApplication modern = new WindowApplication(link, options, onShown);
        modern.open(AppSettings.LWJGL_OPENGL32);
        if (modern.problem() == null || modern.problem().contains(NO_SERVER) || modern.isMisfit()) {
            return modern;
        }
        WindowApplication old = new WindowApplication(link, options, onShown);
        old.open(AppSettings.LWJGL_OPENGL2);
        return old;
    }
}
