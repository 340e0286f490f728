// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.TimeStep;
import org.SEAR.sensors.CameraImage;
import org.SEAR.simulator.Simulation;

/**
 * Puts camera pictures into a record. A thread of its own encodes them, one per camera at a time. The next picture puts
 * the previous one into the record, after waiting for its encoder if necessary. A record therefore always has the same
 * bytes, and each camera needs memory for one picture. Simulation thread.
 */
final class PictureKeeper {
    /** The order is that of their numbers in the file. */
    static final List<String> KINDS = List.of(Camera.COLOR, Camera.DEPTH, Camera.INFRARED);
    /** Maximum bytes of a picture; the largest camera's picture is smaller. */
    static final int LONGEST_PICTURE = 1 << 23;

    private final Simulation simulation;
    private final double rate;
    private final LogBuffer out;
    private final List<Eye> eyes = new ArrayList<>();
    private final ExecutorService maker = Executors.newSingleThreadExecutor(work -> {
        Thread thread = new Thread(work, "pictures of a record");
        thread.setDaemon(true);
        return thread;
    });

    private static final class Eye {
        final int sensor;
        final String name;
        final int kind;
        /** Pictures per simulated second that the camera takes. */
        final double rate;
        /** The camera's picture number when the last one was kept. */
        long due = -1;
        /** Number of the record's period from which on the next picture is kept. */
        long next;
        double time;
        Future<byte[]> file;

        Eye(int sensor, Camera camera) {
            this.sensor = sensor;
            name = camera.getFullName();
            kind = KINDS.indexOf(camera.getKind());
            rate = camera.getRate();
        }
    }

    /**
     * Begins with the next {@link #look}.
     *
     * @param sensors sensors of the record, in its order
     * @param rate pictures per camera and simulated second, above 0
     */
    PictureKeeper(Simulation simulation, List<String> sensors, double rate, LogBuffer out) {
        this.simulation = simulation;
        this.rate = rate;
        this.out = out;
        for (int i = 0; i < sensors.size(); i++) {
            SearObject object = simulation.getJoints().isRead(sensors.get(i)) ? null
                : simulation.getSensor(sensors.get(i)).getParameters();
            if (object instanceof Camera) {
                eyes.add(new Eye(i, (Camera) object));
            }
        }
    }

    /**
     * Keeps the pictures that are due.
     *
     * @param now seconds since the record began
     */
    void look(double now) {
        for (Eye eye : eyes) {
            CameraImage image = (CameraImage) simulation.read(eye.name);
            double time = Math.max(0, now - (simulation.snapshot().time - image.getTime()));
            long number = TimeStep.periods(time, rate);
            // before the first due picture, each moment has an image of its own
            long due = TimeStep.periods(image.getTime(), eye.rate);
            if (due != eye.due && number >= eye.next) {
                put(eye);
                eye.due = due;
                eye.next = Math.max(eye.next + 1, number); // a late picture does not cost the next one
                eye.time = time;
                eye.file = maker.submit(() -> image.grid().file());
            }
        }
    }

    private void put(Eye eye) {
        if (eye.file == null) {
            return;
        }
        try {
            byte[] file = eye.file.get();
            out.put(EventKind.PICTURE).putShort(eye.sensor).put(eye.kind).putDouble(eye.time).putInt(file.length)
                .putBytes(file, file.length);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (ExecutionException e) {
            throw new IllegalStateException("a picture of camera " + eye.name + " could not be kept: "
                + e.getCause(), e);
        }
        eye.file = null;
    }

    /** Puts the last pictures into the record and shuts the encoder down. */
    void end() {
        eyes.forEach(this::put);
        maker.shutdown();
    }
}
