// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.io.IOException;
import java.util.concurrent.TimeUnit;
import org.SEAR.sensors.CameraImage;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.readings.ScriptCameras;

/**
 * A camera at a TCP port that outlives simulations. Renders pictures only for viewers, when they are due, and for at
 * most half of the time, to leave time for the simulation. Any thread.
 */
final class NetworkCamera {
    /** Interval of checks for a due picture, milliseconds. */
    private static final long LOOK = 4;
    /** Interval after which an unchanged picture is sent again, ns: programs treat a silent camera as broken. */
    private static final long REPEAT = TimeUnit.SECONDS.toNanos(1);
    private static final long LONGEST_REST = 1000;

    private final String camera;
    private final DeviceProfile profile;
    private final Host host;
    private final ScriptCameras cameras;
    private final Demand demand;
    private final PictureServer server;
    private EncodedFrame last;
    private long reported = -1;
    private long published;
    private boolean watched;
    private String failure = "";

    private NetworkCamera(String camera, DeviceProfile likeness, Host host, ScriptCameras cameras, Demand demand,
        PictureServer server) {
        this.camera = camera;
        this.profile = likeness;
        this.host = host;
        this.cameras = cameras;
        this.demand = demand;
        this.server = server;
    }

    /**
     * Opens a network camera.
     *
     * @param number TCP port, 0 for any free one
     * @param timeout milliseconds without progress after which a client is dropped
     */
    static NetworkCamera open(String camera, DeviceProfile likeness, int number, Host host, ScriptCameras cameras,
        long timeout) throws IOException {
        Demand demand = new Demand();
        PictureServer server = PictureServer.open(camera, likeness, number, demand, timeout);
        NetworkCamera opened = new NetworkCamera(camera, likeness, host, cameras, demand, server);
        start(server::serve, "network camera " + camera);
        start(opened::supply, "pictures of network camera " + camera);
        return opened;
    }

    private static void start(Runnable work, String name) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }

    String getCamera() {
        return camera;
    }

    /** Returns the first of its TCP ports. */
    int getNumber() {
        return server.getNumber();
    }

    /** Returns the number of connected programs. */
    int getClients() {
        return server.getClients();
    }

    /** Returns a description with the address that programs open. */
    String describe() {
        return "network camera " + (profile == DeviceProfile.PLAIN ? "" : "(" + profile.getTitle() + ") ")
            + profile.stream(getNumber());
    }

    private void supply() {
        try {
            for (Demand.Order order = demand.await(LOOK); order != null; order = demand.await(LOOK)) {
                try {
                    serve(order);
                } catch (RuntimeException e) {
                    report(e);
                    server.answer(order.ticket, null);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void report(RuntimeException e) {
        if (!e.toString().equals(failure)) {
            failure = e.toString();
            host.warn("the network camera " + camera + " has no picture: " + failure);
        }
    }

    private void serve(Demand.Order order) throws InterruptedException {
        long due = cameras.due(camera);
        boolean fresh = order.streaming && !watched;
        watched = order.streaming;
        if (due < 0) {
            lose();
        } else if (!order.forms.isEmpty() || fresh || order.streaming
            && (due != reported || System.nanoTime() - published > REPEAT)) {
            look(due, fresh);
        }
        if (!order.forms.isEmpty()) {
            EncodedFrame shot = last;
            if (shot != null) {
                order.forms.forEach(shot::file);
            }
            server.answer(order.ticket, shot);
        }
    }

    private void lose() {
        if (last != null) {
            last = null;
            server.publish(null);
        }
    }

    private void look(long due, boolean fresh) throws InterruptedException {
        long began = System.nanoTime();
        CameraImage image = cameras.look(camera);
        if (image == null) {
            lose();
            return;
        }
        boolean isNew = last == null || image != last.getImage();
        if (isNew) {
            last = new EncodedFrame(image);
            reported = due;
        }
        if (watched && (isNew || fresh || System.nanoTime() - published > REPEAT)) {
            last.file(Form.STREAM);
            published = System.nanoTime();
            server.publish(last);
        }
        if (isNew) {
            demand.rest(Math.min(LONGEST_REST, TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - began)));
        }
    }

    /** Closes the ports and all connections. */
    void close() {
        demand.close();
        server.close();
    }
}
