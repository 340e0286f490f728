package org.SEAR.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import org.myrobotlab.embedded.PythonEngine;
import org.myrobotlab.embedded.Shutdown;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import picocli.CommandLine;

/** Runs one script in the embedded MyRobotLab, from start to release. */
final class ScriptRun {
    /** No tabs. */
    static final int NO_PORT = -1;
    static final int HIGHEST_PORT = 65535;

    private static final String PYTHON = "python";

    private final Path script;
    private final int port;
    private final boolean token;
    private final boolean keep;
    private final PrintWriter err;
    private final CountDownLatch shutdown = new CountDownLatch(1);

    ScriptRun(Path script, int port, boolean token, boolean keep, PrintWriter err) {
        this.script = script;
        this.port = port;
        this.token = token;
        this.keep = keep;
        this.err = err;
    }

    /** @return the exit status */
    int run() throws IOException, InterruptedException {
        if (!Files.isReadable(script) || Files.isDirectory(script)) {
            err.println("sear: script " + script + " can't be read: there is no such file. Try sear --help.");
            return CommandLine.ExitCode.USAGE;
        }
        Shutdown.then(shutdown::countDown);
        Thread release = new Thread(Runtime::releaseAll, "release");
        java.lang.Runtime.getRuntime().addShutdownHook(release);
        ServiceInterface python = Runtime.start(PYTHON, "Python");
        if (!(python instanceof Python)) {
            return CommandLine.ExitCode.SOFTWARE;
        }
        if (port != NO_PORT) {
            Tabs.start(port, token, err);
        }
        ((Python) python).execFile(script.toString());
        PythonEngine engine = PythonEngine.of(PYTHON);
        int status = engine == null ? CommandLine.ExitCode.OK : engine.getLastResult().getExitCode();
        if (keep) {
            shutdown.await();
        }
        Runtime.releaseAll();
        return status;
    }
}
