// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.myrobotlab.embedded.python.PythonEngine;
import org.myrobotlab.embedded.Shutdown;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import picocli.CommandLine.ExitCode;

/** One run of the embedded MyRobotLab, from start to release: of a script, or with a project open in the tabs. */
final class MrlRun {
    /** Port value for no tabs. */
    static final int NO_PORT = -1;
    static final int HIGHEST_PORT = 65535;

    /** Time for callbacks to finish after the script's end, ms. */
    private static final int CALLBACK_MILLIS = 5000;
    private static final long WATCH_MILLIS = 20;
    private static final String PYTHON = "python";
    private static final String SEAR_NAME = "sear";
    private static final String PROJECT = "SEARproject";

    private final int port;
    private final boolean isKnown;
    private final PrintWriter err;
    private final CountDownLatch shutdown = new CountDownLatch(1);
    private String address;
    private boolean released;
    private volatile boolean timeIsUp;

    /** @param isKnown whether the port was announced already, so that another one is useless */
    MrlRun(int port, boolean isKnown, PrintWriter err) {
        this.port = port;
        this.isKnown = isKnown;
        this.err = err;
    }

    /**
     * Starts Python.
     *
     * @return the Python service; null on failure
     */
    private Python start() {
        Shutdown.then(shutdown::countDown);
        java.lang.Runtime.getRuntime().addShutdownHook(new Thread(this::release, "release"));
        ParentProcess.watch();
        ServiceInterface python = Runtime.start(PYTHON, "Python");
        return python instanceof Python ? (Python) python : null;
    }

    /**
     * Serves the tabs of the services that have started, and prints the address.
     *
     * @return whether the run can go on
     */
    private boolean serve() {
        if (port != NO_PORT) {
            address = Tabs.start(port, isKnown, err);
        }
        return address != null || !isKnown;
    }

    /** Ends scripts before the services they wait for, to avoid error messages. */
    private void release() {
        synchronized (this) {
            released = true;
        }
        PythonEngine engine = PythonEngine.of(PYTHON);
        if (engine != null) {
            engine.interrupt();
        }
        Runtime.releaseAll();
    }

    /** Stops simulations and so the threads that wait for simulated time, unless Ctrl+C has released everything. */
    private synchronized void stopSimulations() {
        if (!released) {
            Runtime.getServices().forEach(MrlRun::stop);
        }
    }

    private static void stop(ServiceInterface service) {
        if (service instanceof SEAR && ((SEAR) service).isSimulating()) {
            ((SEAR) service).stopSimulation();
        }
    }

    /** Stops the script, repeatedly if it goes on, when a simulation has reached the time. */
    private void watch(Python python, double until) {
        try {
            while (!shutdown.await(WATCH_MILLIS, TimeUnit.MILLISECONDS)) {
                timeIsUp |= Runtime.getServices().stream()
                    .anyMatch(one -> one instanceof SEAR && isPast((SEAR) one, until));
                if (timeIsUp) {
                    python.stop();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static boolean isPast(SEAR sear, double until) {
        try {
            return sear.isSimulating() && sear.getTime() >= until;
        } catch (IllegalStateException e) {
            return false;       // the simulation has just ended
        }
    }

    /**
     * Runs a script.
     *
     * @param keep whether to stay until Ctrl+C or Runtime.shutdown()
     * @param until simulated seconds after which the script is stopped
     * @return the exit status
     */
    int script(Path script, List<String> arguments, boolean keep, double until)
        throws IOException, InterruptedException {
        Python python = start();
        PythonEngine engine = PythonEngine.of(PYTHON);
        if (python == null || engine == null || !serve()) {
            return ExitCode.SOFTWARE;
        }
        engine.setArguments(arguments);
        if (until < Double.POSITIVE_INFINITY) {
            Thread watch = new Thread(() -> watch(python, until), "until");
            watch.setDaemon(true);
            watch.start();
        }
        python.execFile(script.toString());
        int status = PythonEngine.of(PYTHON) == null || timeIsUp ? ExitCode.OK : engine.getLastResult().getExitCode();
        if (keep) {
            shutdown.await();
        } else {
            engine.finishCallbacks(CALLBACK_MILLIS);    // reports the errors of callbacks
            stopSimulations();
            engine.finishThreads(CALLBACK_MILLIS);
        }
        release();
        return status == ExitCode.OK && engine.getFailure() != null ? ExitCode.SOFTWARE : status;
    }

    /**
     * Shows a project in the tabs until Ctrl+C or Runtime.shutdown().
     *
     * @param path a bundle, a project's folder or its parent folder; null for the working folder's project, which may
     *     be empty
     * @param inBrowser whether to open a browser, if there is one
     * @return the exit status
     */
    int project(Path path, boolean inBrowser) throws InterruptedException {
        if (path != null && Files.isDirectory(path)) {
            Path inside = path.resolve(PROJECT);
            System.setProperty("sear.project", (Files.isDirectory(inside) ? inside : path).toString());
        }
        Python python = start();
        ServiceInterface sear = Runtime.start(SEAR_NAME, "SEAR");
        if (python == null || !(sear instanceof SEAR)) {
            return ExitCode.SOFTWARE;
        }
        if (path != null && !Files.isDirectory(path)) {
            try {
                ((SEAR) sear).loadProject(path.toString());
            } catch (IllegalArgumentException | IllegalStateException e) {
                err.println("sear: " + path + " can't be opened: " + e.getMessage());
                release();
                return ExitCode.USAGE;
            }
        }
        if (!serve()) {
            return ExitCode.SOFTWARE;
        }
        if (address != null && inBrowser && !Tabs.asksForToken()) {    // other users can see the arguments of processes
            Browser.open(address + "#/" + SEAR_NAME);
        }
        shutdown.await();
        release();
        return ExitCode.OK;
    }
}
