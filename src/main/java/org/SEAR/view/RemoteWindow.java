// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.SEAR.scene.ReadingTexts;
import org.SEAR.view.link.WorldLink;
import org.SEAR.view.platform.DisplayCheck;
import org.SEAR.view.process.StateMessage;
import org.SEAR.view.process.WindowProtocol;

/** Handle of a window in its own process, in the simulation's process. Any thread. */
final class RemoteWindow implements WindowHandle {
    /** Maximum time to start a process and open a window, seconds. */
    private static final long TIMEOUT = 60;
    private static final long FEED_PERIOD = TimeUnit.MILLISECONDS.toNanos(25);

    private final WorldLink world;
    private final WindowOptions options;
    private final Process process;
    private final CountDownLatch settled = new CountDownLatch(1);
    private final Thread feeder;
    private final Thread listener;
    private volatile String problem;
    private volatile boolean open;
    private volatile boolean closing;

    private RemoteWindow(WorldLink world, WindowOptions options) throws IOException {
        this.world = world;
        this.options = options;
        process = new ProcessBuilder(command(options, world)).redirectError(ProcessBuilder.Redirect.INHERIT).start();
        feeder = start(this::feed, "SEAR window feed");
        listener = start(this::listen, "SEAR window commands");
    }

    /** Starts the process and waits for its window, or for the reason why there is none. */
    static RemoteWindow open(WorldLink world, WindowOptions options) throws IOException, InterruptedException {
        RemoteWindow window = new RemoteWindow(world, options);
        if (!window.settled.await(TIMEOUT, TimeUnit.SECONDS)) {
            window.problem = "the window's process did not open it within " + TIMEOUT + " s";
        }
        if (window.problem != null) {
            window.end();
        }
        return window;
    }

    private static Thread start(Runnable task, String name) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    private static List<String> command(WindowOptions options, WorldLink world) {
        List<String> command = new ArrayList<>();
        command.add(System.getProperty("java.home") + File.separator + "bin" + File.separator + "java");
        if (DisplayCheck.needsFirstThread()) {
            command.add("-XstartOnFirstThread");
        }
        command.addAll(Arrays.asList("-Xmx256m", "-cp", System.getProperty("java.class.path"), WindowProcess.class.getName(),
            world.project().getFolder().toAbsolutePath().toString(), options.getTitle(), String.valueOf(options.getWidth()),
            String.valueOf(options.getHeight()), String.valueOf(options.isDebugShapes()),
            options.getScreenshotFolder().toAbsolutePath().toString()));
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
            options.getWarnings().accept("the simulator window's process has ended; the simulation continues without it");
            world.close();
        }
    }

    @Override
    public boolean isOpen() {
        return open && !closing;
    }

    @Override
    public String problem() {
        return problem;
    }

    @Override
    public void close() {
        closing = true;
        if (open) {
            open = false;
            world.close();
        }
        end();
    }

    private void end() {
        closing = true;
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
