// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.platform;

import com.sun.jna.Callback;
import com.sun.jna.Function;
import com.sun.jna.NativeLibrary;
import com.sun.jna.Platform;
import com.sun.jna.Pointer;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.lwjgl.glfw.GLFWNativeX11;

/**
 * Prevents an X server from ending the whole process: Xlib's default handlers call {@code exit(1)} on connection loss
 * or a failed request. Installed once per window, on its thread. Errors of other windows go to the previous handlers.
 */
public final class X11Guard {
    private static final Logger LOG = Logger.getLogger(X11Guard.class.getName());
    private static final String LIBRARY = "libX11.so.6";
    /** Static because Xlib may call the handlers at any time. */
    private static final ErrorHandler REFUSED = X11Guard::refused;
    private static final ConnectionHandler BROKEN = X11Guard::broken;
    private static final ExitHandler LOST = X11Guard::lost;
    private static final AtomicBoolean INSTALLED = new AtomicBoolean();
    private static volatile long display;
    private static volatile boolean gone;
    private static volatile Runnable onLost;
    private static volatile Pointer refusedBefore;
    private static volatile Pointer brokenBefore;

    /** Xlib's {@code XErrorHandler}. */
    public interface ErrorHandler extends Callback {
        int invoke(Pointer display, Pointer event);
    }

    /** Xlib's {@code XIOErrorHandler}. */
    public interface ConnectionHandler extends Callback {
        int invoke(Pointer display);
    }

    /** Xlib's {@code XIOErrorExitHandler}. */
    public interface ExitHandler extends Callback {
        void invoke(Pointer display, Pointer data);
    }

    private X11Guard() {
    }

    /**
     * Guards the display of the open window. Does nothing without X11.
     * @param lost called on connection loss
     */
    public static void install(Runnable lost) {
        display = 0;
        gone = false;
        if (!Platform.isX11()) {
            return;
        }
        try {
            display = GLFWNativeX11.glfwGetX11Display();
            if (display == 0) {
                return;
            }
            onLost = lost;
            NativeLibrary xlib = NativeLibrary.getInstance(LIBRARY);
            Function exit = xlib.getFunction("XSetIOErrorExitHandler");
            if (INSTALLED.compareAndSet(false, true)) {
                refusedBefore = (Pointer) xlib.getFunction("XSetErrorHandler").invoke(Pointer.class, new Object[] {REFUSED});
                brokenBefore = (Pointer) xlib.getFunction("XSetIOErrorHandler").invoke(Pointer.class, new Object[] {BROKEN});
            }
            exit.invokeVoid(new Object[] {new Pointer(display), LOST, Pointer.NULL});
        } catch (UnsatisfiedLinkError e) {
            LOG.log(Level.FINE, "Xlib is older than 1.7: losing the X server ends this process", e);
        }
    }

    /**
     * Waits for a reply of the X server. Call before each picture: Mesa asks the server for the window's size. Without
     * a reply, Mesa draws with an undefined size, which ends the process. Window thread.
     * @return whether the server replied; true without X11, and for a window without a guard
     */
    public static boolean answers() {
        if (display == 0 || display != GLFWNativeX11.glfwGetX11Display()) {
            return true; // no X11, or the display of a closed window
        }
        if (!gone) {
            NativeLibrary.getInstance(LIBRARY).getFunction("XSync").invokeVoid(new Object[] {new Pointer(display), 0});
        }
        return !gone;
    }

    private static int refused(Pointer where, Pointer event) {
        if (Pointer.nativeValue(where) == display || refusedBefore == null) {
            LOG.log(Level.WARNING, "the X server refused a request of the simulator window");
            return 0;
        }
        return Function.getFunction(refusedBefore).invokeInt(new Object[] {where, event});
    }

    private static int broken(Pointer where) {
        if (Pointer.nativeValue(where) == display || brokenBefore == null) {
            return 0;
        }
        return Function.getFunction(brokenBefore).invokeInt(new Object[] {where});
    }

    private static void lost(Pointer where, Pointer data) {
        gone = true;
        Runnable action = onLost;
        if (action != null) {
            action.run();
        }
    }
}
