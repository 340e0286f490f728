package org.SEAR.view;

import com.jme3.system.AppSettings;
import org.SEAR.view.link.WorldLink;

/** Keeps the first mention of jMonkeyEngine's classes out of {@link SimulatorWindow}, where a missing jar must not end in an error. */
final class WindowStart {
    /** GLFW's words for an X server that doesn't answer. */
    private static final String NO_SERVER = "Failed to open display";

    private WindowStart() {
    }

    /**
     * Opens a window on OpenGL 3.2 or, on an old machine, 2.0. On macOS, where it has to run on the caller's thread, it returns when the window has
     * been closed; elsewhere when it shows its first picture.
     *
     * @param onShown called on the window's thread after the first picture
     * @return the last window tried; look at its problem
     */
    static WindowHandle open(WorldLink link, WindowOptions options, Runnable onShown) throws InterruptedException {
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
