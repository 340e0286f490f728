package org.SEAR.view;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicReference;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.view.link.RunnerLink;
import org.SEAR.view.link.WorldLink;
import org.SEAR.view.platform.DisplayCheck;

/**
 * The window that shows a running simulation. It reads snapshots and sends commands on a thread of its own; the simulation neither waits for it
 * nor depends on it, and a machine without display or OpenGL simply has no window.
 *
 * <p>Any thread. No jMonkeyEngine type appears in this class, so it loads where jMonkeyEngine's jars are missing. A process can have one window at a
 * time, because GLFW, the library below jMonkeyEngine, is ended with it. On macOS, where a window must have a process's first thread, it runs in a
 * process of its own.
 */
public final class SimulatorWindow implements AutoCloseable {
    private static final String WITHOUT = "; the simulation runs without a window";
    private static final AtomicReference<SimulatorWindow> PRESENT = new AtomicReference<>();

    private WindowHandle body;
    private String problem;

    private SimulatorWindow() {
    }

    /**
     * Opens a window and returns when it shows its first picture, or when it is clear that there can't be one.
     *
     * @param runner of the simulation to show; only looked at and sent commands, never started or stopped
     * @param options how it looks and behaves; also takes the warning when there can't be a window
     * @return never null, and never an exception for a machine without display: look at {@link #isHeadless}
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

    /** Whether the window is there. */
    public boolean isOpen() {
        return problem == null && body.isOpen();
    }

    /** Whether there never was a window: no display, no OpenGL, or jMonkeyEngine missing. {@link #getProblem} says why. */
    public boolean isHeadless() {
        return problem != null;
    }

    /** Why there is no window, in plain words; null when there is or was one. */
    public String getProblem() {
        return problem;
    }

    /** Takes the window away and waits until it is gone. Does nothing when it is gone already. The simulation goes on. */
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
