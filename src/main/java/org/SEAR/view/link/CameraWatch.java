// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.link;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.SEAR.sensors.CameraImage;
import org.SEAR.simulator.Simulation;

/**
 * Requests pictures of one camera from the simulation while a window shows it, on its own thread. It requests at most
 * ten per second and pauses at least as long as each picture takes, to leave time for the simulation. Any thread.
 */
final class CameraWatch {
    /** Minimum time between requests, ns. */
    private static final long PERIOD = TimeUnit.MILLISECONDS.toNanos(100);
    private static final long TIMEOUT_SECONDS = 10;

    private final Simulation simulation;
    private final ScheduledThreadPoolExecutor eyes = new ScheduledThreadPoolExecutor(1, task -> {
        Thread thread = new Thread(task, "SEAR window pictures");
        thread.setDaemon(true);
        return thread;
    });
    private volatile String wanted;
    private volatile CameraFrame shot;
    /** Whether a request is running or scheduled. */
    private boolean looking;
    private CameraImage last;

    CameraWatch(Simulation simulation) {
        this.simulation = simulation;
    }

    /** @param camera camera to request, or null */
    synchronized void want(String camera) {
        wanted = camera;
        shot = null;
        if (camera != null && !looking && !eyes.isShutdown()) {
            looking = true;
            eyes.execute(this::look);
        }
    }

    /** Stops all requests. */
    synchronized void close() {
        wanted = null;
        eyes.shutdownNow();
    }

    /** Returns the newest picture, or null. */
    CameraFrame shot() {
        return shot;
    }

    private void look() {
        long began = System.nanoTime();
        String camera = wanted;
        try {
            if (camera != null) {
                CameraImage image = simulation.ask(world -> (CameraImage) world.read(camera))
                    .get(TIMEOUT_SECONDS, TimeUnit.SECONDS);
                CameraFrame present = shot;
                if (image != last || present == null || !present.camera.equals(camera)) {
                    last = image;
                    show(camera, CameraFrame.of(camera, image));
                }
            }
        } catch (ExecutionException | TimeoutException e) {
            show(camera, null);       // the simulation ends or is busy: try again later
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return;
        }
        again(Math.max(PERIOD, System.nanoTime() - began));
    }

    private synchronized void show(String camera, CameraFrame now) {
        if (camera.equals(wanted)) {
            shot = now;
        }
    }

    private synchronized void again(long pause) {
        looking = wanted != null && !eyes.isShutdown();
        if (looking) {
            eyes.schedule(this::look, pause, TimeUnit.NANOSECONDS);
        }
    }
}
