// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicReference;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.view.link.RunnerLink;
import org.SEAR.view.link.WorldLink;
import org.SEAR.view.platform.DisplayCheck;

/**
 * Window of a running simulation. It reads snapshots and sends commands on its own thread. The simulation does not wait
 * for it, and runs without a window on a machine without display or OpenGL.
 *
 * <p>Any thread. This class uses no jMonkeyEngine types, so it loads without jMonkeyEngine's jars. A process can have
 * one window at a time, because closing it terminates GLFW, jMonkeyEngine's window library. On macOS, where a window
 * needs a process's first thread, it runs in its own process.
 */
public final class SimulatorWindow implements AutoCloseable {
    private static final String WITHOUT = "; the simulation runs without a window";
    private static final AtomicReference<SimulatorWindow> PRESENT = new AtomicReference<>();

    private WindowHandle body;
    private String problem;

    private SimulatorWindow() {
    }

    /**
     * Opens a window. Returns when it shows its first picture, or when there can't be one.
     * @param runner simulation to show; the window never starts or stops it
     * @param options look and behaviour, including the receiver of warnings
     * @return never null; without a display, {@link #isHeadless} is true
     */
    public static SimulatorWindow open(SimulationRunner runner, WindowOptions options) {
        return open(new RunnerLink(runner, options.getScriptDrives()), options);
    }

    static SimulatorWindow open(WorldLink link, WindowOptions options) {
        SimulatorWindow window = new SimulatorWindow();
        String problem = DisplayCheck.problem();
        if (problem == null && !PRESENT.compareAndSet(null, window)) {
            SimulatorWindow present = PRESENT.get();
            boolean gone = present != null && !present.isOpen() && PRESENT.compareAndSet(present, window);
            problem = gone ? null : "another simulator window is open in this process: close it first";
        }
        if (problem == null) {
            problem = window.start(link, options);
        }
        if (problem != null) {
            link.close();
            PRESENT.compareAndSet(window, null);
            window.problem = problem + WITHOUT;
            options.getWarnings().accept(window.problem);
        }
        return window;
    }

    private String start(WorldLink link, WindowOptions options) {
        try {
            body = options.isOwnProcess() ? RemoteWindow.open(link, options) : WindowStart.open(link, options, () -> { });
            return body.problem() == null ? null : "no window could be opened (" + body.problem() + ")";
        } catch (IOException e) {
            return "the window's process could not be started (" + e.getMessage() + ")";
        } catch (RuntimeException | LinkageError e) {
            return "jMonkeyEngine or its native libraries can't be loaded (" + e + ")";
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return "interrupted while the window was opening";
        }
    }

    public boolean isOpen() {
        return problem == null && body.isOpen();
    }

    /**
     * Returns whether no window could open: no display, no OpenGL, or no jMonkeyEngine. {@link #getProblem} returns the
     * reason.
     */
    public boolean isHeadless() {
        return problem != null;
    }

    /** Returns why no window could open, or null. */
    public String getProblem() {
        return problem;
    }

    /** Closes the window and waits for its end. Does nothing for a closed window. The simulation continues. */
    @Override
    public void close() {
        if (problem == null) {
            body.close();
            PRESENT.compareAndSet(this, null);
        }
    }

    WindowHandle body() {
        return body;
    }
}
