// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.records;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.SEAR.grammar.ScriptText;
import org.SEAR.record.Recorder;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;

/** The present record, or the one that starts with the next simulation. Any thread. */
public final class Recording {
    /** Default size at which a record ends. */
    public static final double MEGABYTES = 512;
    /**
     * System property with the path of an additional record of each run, set by the program's user; a later run
     * replaces it.
     */
    private static final String KEPT = "sear.record";
    static final String ENDING = ".searlog";
    private static final long MEGABYTE = 1 << 20;
    private static final long KEPT_MEGABYTES = 64;
    private static final double MAX_MEGABYTES = 100000;
    /** Most pictures per simulated second; the number of frames in a record. */
    private static final double MAX_PICTURES = 30;

    private final SimulationControl control;
    private final Host host;
    private Path wanted;
    private long limit;
    private double rate;
    private Recorder recorder;
    /** The additional record of the system property; null if there is none. */
    private Recorder kept;

    public Recording(SimulationControl control, Host host) {
        this.control = control;
        this.host = host;
        control.setStartListener(this::started);
    }

    /**
     * Starts a record now, or with the next simulation if none runs.
     *
     * @param path gets the ending .searlog if it has none; its folder must exist
     * @param megabytes size at which the record ends
     * @param pictures pictures of each camera per simulated second, 0 for none
     * @return the absolute path with its ending
     */
    public synchronized String begin(String path, double megabytes, double pictures)
        throws IOException, InterruptedException {
        if (path == null || path.isEmpty()) {
            throw new IllegalArgumentException(
                "the path is missing, legal: the path of a file, such as \"run.searlog\"");
        }
        if (!(megabytes > 0 && megabytes <= MAX_MEGABYTES)) {
            throw new IllegalArgumentException("recordRun: megabytes is " + megabytes + ", legal: above 0 to "
                + MAX_MEGABYTES);
        }
        if (!(pictures >= 0 && pictures <= MAX_PICTURES)) {
            throw new IllegalArgumentException("recordRun: pictures is " + pictures + ", legal: 0 to " + MAX_PICTURES
                + " per second");
        }
        if (wanted != null) {
            throw new IllegalStateException("a record is being written to " + wanted
                + " already: call endRecord() first");
        }
        Path file = ScriptText.path(path.endsWith(ENDING) ? path : path + ENDING);
        Path parent = file.toAbsolutePath().getParent();
        if (parent == null || !Files.isDirectory(parent)) {
            throw new IOException(file + " can't be written: there is no folder " + parent
                + "; create it, or choose another");
        }
        Recorder.check(file);
        long most = (long) (megabytes * MEGABYTE);
        SimulationSession session = control.sessionOrNull();
        if (session != null) {
            recorder = session.ask(world -> made(world, file, most, pictures));
        }
        limit = most;
        rate = pictures;
        wanted = file;
        return file.toAbsolutePath().normalize().toString();
    }

    /** Creates the recorder; throws IOException of the file as IllegalStateException. */
    private Recorder made(Simulation world, Path file, long most, double pictures) {
        try {
            return Recorder.begin(world, file, most, pictures, host::warn);
        } catch (IOException e) {
            throw new IllegalStateException("the record can't be written: " + e.getMessage(), e);
        }
    }

    /** Called before the first step of a simulation. */
    private synchronized void started(Simulation world) {
        String keptFile = System.getProperty(KEPT);
        if (keptFile != null) {
            kept = made(world, Paths.get(keptFile), KEPT_MEGABYTES * MEGABYTE, 0);
        }
        if (wanted != null && recorder == null) {
            recorder = made(world, wanted, limit, rate);
        }
    }

    /** Returns whether a record is being written or will be. */
    public synchronized boolean isOn() {
        return wanted != null;
    }

    /**
     * Ends the record.
     *
     * @return its simulated seconds
     * @throws IllegalStateException if there is none
     */
    public synchronized double end() throws IOException, InterruptedException {
        if (wanted == null) {
            throw new IllegalStateException("no record is being written: call recordRun(\"run.searlog\") to start one");
        }
        Recorder present = recorder;
        wanted = null;
        recorder = null;
        SimulationSession session = control.sessionOrNull();
        if (present == null) {
            return 0;
        }
        if (session != null) {
            session.ask(world -> {
                present.leave();
                return true;
            });
        }
        present.end();
        return present.getSeconds();
    }

    /** Ends the record after the end of its simulation. */
    public void stopped() {
        try {
            if (hasBegun()) {
                end();
            }
            endKept();
        } catch (IOException e) {
            host.error("the record of the run: " + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized void endKept() throws IOException {
        if (kept != null) {
            kept.end();
            kept = null;
        }
    }

    private synchronized boolean hasBegun() {
        return recorder != null;
    }
}
