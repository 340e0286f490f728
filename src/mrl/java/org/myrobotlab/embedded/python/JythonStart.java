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

/** What Python has to do once in a JVM before the first script, which takes longest of all that has to be done before it. Any thread. */
public final class JythonStart {
    private static final Logger LOG = LoggerFactory.getLogger(JythonStart.class);
    /** Whose classes scripts import all at once. */
    private static final String OBJECTS = "org.SEAR.POJOs";
    /** It has the parser and the compiler loaded. */
    private static final String FIRST = "import org\n";
    /**
     * Where Python's own modules are in its jar. They are looked for one by one, for a list of all that is in the jar, 25,000 files, takes a tenth of
     * the time until a script begins.
     */
    private static final String LIBRARY = "Lib";
    private static boolean done;

    private JythonStart() {
    }

    /** Begins on a thread of its own, while the one that calls does other things. */
    public static void begin() {
        Thread thread = new Thread(JythonStart::tryToWarmUp, "jython start");
        thread.setDaemon(true);
        thread.start();
    }

    /** A program that ends meanwhile, by Ctrl+C or for want of its script, needs no Python any more; else the script's interpreter has the error. */
    private static void tryToWarmUp() {
        try {
            warmUp();
        } catch (IllegalStateException e) {
            LOG.debug("Python was not started: {}", e.toString());
        }
    }

    /** Who wants an interpreter meanwhile waits for the end: what both do takes longer than what one does. */
    private static synchronized void warmUp() {
        await();
        try (PythonInterpreter first = new PythonInterpreter(null, newState())) {
            first.exec(FIRST);
        }
    }

    /** All that is the same for each interpreter is there when it returns. */
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
            PySystemState.add_package(OBJECTS, String.join(",", PackageClasses.of(OBJECTS, JythonStart.class.getClassLoader())));
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
