// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.sweep;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.myrobotlab.embedded.python.PythonEngine;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;

/** Runs Jython scripts one after the other in one JVM, each in a new MyRobotLab. Called by Python; one thread. */
public final class ScriptRuns {
    private static final String PYTHON = "python";
    /** Time for callbacks and threads to finish after the script's end, ms. */
    private static final int TIMEOUT_MILLIS = 5000;

    private ScriptRuns() {
    }

    /** Initialises Jython before the first script; takes seconds that must not count as part of a run. */
    public static void prepare() {
        Runtime.start(PYTHON, "Python");
        PythonEngine engine = PythonEngine.of(PYTHON);
        if (engine != null) {
            engine.run("import org\n");
        }
        release();
    }

    /**
     * Runs a script from start to release.
     *
     * @return empty on success; else the error, whose last line is a summary
     */
    public static String run(String script) throws IOException, InterruptedException {
        try {
            ServiceInterface python = Runtime.start(PYTHON, "Python");
            PythonEngine engine = PythonEngine.of(PYTHON);
            if (!(python instanceof Python) || engine == null) {
                throw new IllegalStateException("Python can't start");
            }
            List<String> errors = new ArrayList<>();
            engine.setFailed(errors::add);
            ((Python) python).execFile(script);
            engine.finishCallbacks(TIMEOUT_MILLIS);
            stopSimulations();
            engine.finishThreads(TIMEOUT_MILLIS);
            String traceback = engine.getLastResult().getTraceback();
            if (traceback != null) {
                return traceback;
            }
            if (engine.getLastResult().getExitCode() != 0) {
                return "exit status " + engine.getLastResult().getExitCode();
            }
            return engine.getFailure() == null ? "" : errors.isEmpty() ? engine.getFailure() : errors.get(0);
        } finally {
            release();
        }
    }

    /** Stops all simulations and releases all services, so that the next run finds none. */
    public static void release() {
        stopSimulations();
        Runtime.releaseAll();
    }

    private static void stopSimulations() {
        for (ServiceInterface service : Runtime.getServices()) {
            if (service instanceof SEAR && ((SEAR) service).isSimulating()) {
                ((SEAR) service).stopSimulation();
            }
        }
    }
}
