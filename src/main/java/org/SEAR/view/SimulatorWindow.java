// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.SEAR.scene.ReadingTexts;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.view.link.RunnerLink;
import org.SEAR.view.link.WorldLink;
import org.SEAR.view.platform.DisplayCheck;
import org.SEAR.view.process.StateMessage;
import org.SEAR.view.process.WindowProtocol;

/**
 * Window of a running simulation, in its own process, so that a crash of the graphics driver or a lost display ends
 * only the window. It reads snapshots and sends commands. The simulation does not wait for it, and runs without a
 * window on a machine without display or OpenGL. Uses no jMonkeyEngine types, so it loads without jMonkeyEngine's jars.
 * Any thread.
 */
public final class SimulatorWindow implements AutoCloseable {
    /** Maximum time to start a process and open a window, seconds. */
    private static final long TIMEOUT = 60;
    private static final long FEED_PERIOD = TimeUnit.MILLISECONDS.toNanos(25);

    private final WorldLink world;
    private final WindowOptions options;
    private final CountDownLatch settled = new CountDownLatch(1);
    private Process process;
    private Thread feeder;
    private Thread listener;
    private volatile String problem;
    private volatile boolean open;
    private volatile boolean closing;

    private SimulatorWindow(WorldLink world, WindowOptions options) {
        this.world = world;
        this.options = options;
    }

    /**
     * Opens a window. Returns when it shows its first picture, or when there can't be one.
     * @param runner simulation to show; the window never starts or stops it
     * @param options look and behaviour, including the receiver of warnings
     * @return never null; without a display, {@link #isHeadless} is true
     */
    public static SimulatorWindow open(SimulationRunner runner, WindowOptions options) {
        SimulatorWindow window = new SimulatorWindow(new RunnerLink(runner, options.getScriptDrives()), options);
        String problem = DisplayCheck.problem();
        problem = problem == null ? window.start() : problem;
        if (problem != null) {
            window.close();
            window.world.close();
            window.problem = problem + "; the simulation runs without a window";
            options.getWarnings().accept(window.problem);
        }
        return window;
    }

    /** Starts the process and waits for its window. Returns the reason why there is none, or null. */
    private String start() {
        try {
            process = new ProcessBuilder(command()).redirectError(ProcessBuilder.Redirect.INHERIT).start();
            feeder = start(this::feed, "SEAR window feed");
            listener = start(this::listen, "SEAR window commands");
            String reason = settled.await(TIMEOUT, TimeUnit.SECONDS) ? problem : "its process did not open it within "
                + TIMEOUT + " s";
            return reason == null ? null : "no window could be opened (" + reason + ")";
        } catch (IOException e) {
            return "the window's process could not be started (" + e.getMessage() + ")";
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return "interrupted while the window was opening";
        }
    }

    private static Thread start(Runnable task, String name) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    private List<String> command() {
        List<String> command = new ArrayList<>();
        command.add(System.getProperty("java.home") + File.separator + "bin" + File.separator + "java");
        if (DisplayCheck.needsFirstThread()) {
            command.add("-XstartOnFirstThread");
        }
        command.addAll(List.of("-Xmx256m", "-XX:+UseSerialGC",
            "-XX:ErrorFile=" + Paths.get(System.getProperty("java.io.tmpdir"), "sear-window-%p.log"), "-cp",
            System.getProperty("java.class.path"), WindowProcess.class.getName(), world.project().getFolder()
            .toAbsolutePath().toString(),
            options.getTitle(), String.valueOf(options.getWidth()), String.valueOf(options.getHeight()),
            String.valueOf(options.isDebugShapes()), options.getScreenshotFolder().toAbsolutePath().toString()));
        return command;
    }

    private void feed() {
        try (DataOutputStream out = new DataOutputStream(new BufferedOutputStream(process.getOutputStream()))) {
            ReadingTexts texts = new ReadingTexts(world.project());
            StateMessage before = null;
            while (process.isAlive() && !closing) {
                if (world.snapshot() != null) {
                    StateMessage now = StateMessage.of(world);
                    now.write(out, before, texts);
                    before = now;
                    out.flush();
                }
                LockSupport.parkNanos(FEED_PERIOD);
            }
        } catch (IOException e) {
            ended(e);
        }
    }

    private void listen() {
        try (DataInputStream in = new DataInputStream(new BufferedInputStream(process.getInputStream()))) {
            for (int what = in.read(); what >= 0; what = in.read()) {
                hear(what, in);
            }
            ended(null);
        } catch (IOException e) {
            ended(e);
        }
    }

    private void hear(int what, DataInputStream in) throws IOException {
        switch (what) {
            case WindowProtocol.OPENED:
                open = true;
                settled.countDown();
                break;
            case WindowProtocol.PROBLEM:
                problem = in.readUTF();
                settled.countDown();
                break;
            case WindowProtocol.WARNING:
                options.getWarnings().accept(in.readUTF());
                break;
            case WindowProtocol.CLOSED:
                open = false;
                world.close();
                start(options.getOnClosed(), "SEAR window closed");
                break;
            default:
                if (!WindowProtocol.execute(what, in, world)) {
                    throw new IOException("the window's process sent the unknown message type " + what);
                }
                break;
        }
    }

    /** Handles the end of the process once; both threads may call it. */
    private synchronized void ended(IOException reason) {
        if (settled.getCount() > 0) {
            problem = "the window's process ended" + (reason == null ? "" : " (" + reason.getMessage() + ")");
            settled.countDown();
        } else if (open && !closing) {
            open = false;
            options.getWarnings().accept("the simulator window's process has ended; the simulation "
                + "continues without it");
            world.close();
        }
    }

    public boolean isOpen() {
        return open && !closing;
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

    /**
     * Closes the window and waits for the end of its process. Does nothing for a closed window. The simulation
     * continues.
     */
    @Override
    public void close() {
        closing = true;
        if (open) {
            open = false;
            world.close();
        }
        if (process == null) {
            return;
        }
        process.destroy();
        try {
            process.waitFor();
            feeder.join();
            if (Thread.currentThread() != listener) {
                listener.join();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
