// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.File;
import java.io.IOException;
import java.util.Properties;
import org.python.core.Options;
import org.python.core.PyString;
import org.python.core.PySystemState;
import org.python.util.PythonInterpreter;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Initialises Jython once in a JVM; the slowest part of a start. Any thread. */
public final class JythonStart {
    private static final Logger LOG = LoggerFactory.getLogger(JythonStart.class);
    /** Package for {@code from org.SEAR.POJOs import *}. */
    private static final String OBJECTS = "org.SEAR.POJOs";
    /** Code that loads the parser and the compiler. */
    private static final String FIRST = "import org\n";
    /**
     * Folder of Python's modules in Jython's jar. Modules are looked up one by one, because listing the jar's 25,000
     * files takes a tenth of the start time.
     */
    private static final String LIBRARY = "Lib";
    private static boolean done;

    private JythonStart() {
    }

    /** Begins initialising on a separate thread. */
    public static void begin() {
        Thread thread = new Thread(JythonStart::tryToWarmUp, "jython start");
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * The program may end during initialisation, by Ctrl+C or a missing script. Any other error recurs in the script's
     * interpreter.
     */
    private static void tryToWarmUp() {
        try {
            warmUp();
        } catch (IllegalStateException e) {
            LOG.debug("Python was not started: {}", e.toString());
        }
    }

    /** Others who want an interpreter wait for the end: two initialisations in parallel take longer than one. */
    private static synchronized void warmUp() {
        await();
        try (PythonInterpreter first = new PythonInterpreter(null, newState())) {
            first.exec(FIRST);
        }
    }

    /** Initialises what all interpreters share; returns when that is done. */
    static synchronized void await() {
        if (done) {
            return;
        }
        Properties settings = new Properties();
        settings.setProperty("python.import.site", "false");
        settings.setProperty("python.console.encoding", "UTF-8");
        Options.importSite = false;
        PySystemState.initialize(System.getProperties(), settings, new String[] {""});
        try {
            PySystemState.add_package(OBJECTS,
                String.join(",", PackageClasses.of(OBJECTS, JythonStart.class.getClassLoader())));
        } catch (IOException e) {
            LOG.warn("\"from {} import *\" finds nothing: {}", OBJECTS, e.toString());
        }
        done = true;
    }

    static PySystemState newState() {
        PySystemState state = new PySystemState();
        state.setClassLoader(JythonStart.class.getClassLoader());
        for (int i = 0; i < state.path.__len__(); i++) {
            if (state.path.__getitem__(i).toString().endsWith(".jar" + File.separator + LIBRARY)) {
                state.path.__setitem__(i, new PyString("__pyclasspath__/" + LIBRARY));
            }
        }
        return state;
    }
}
