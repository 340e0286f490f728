// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.sweep;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * {@code sear sweep SCRIPT.py}: runs a script many times, by {@code python3 -m sear.sweeps}, which also checks the
 * options.
 */
@Command(name = "sweep", mixinStandardHelpOptions = true,
    description = "Runs a script for each seed and combination of parameters, in many processes or on many computers, "
    + "and writes a table of the "
        + "results. Needs Dask Distributed: python3 -m pip install numpy JPype1 distributed pyarrow.",
    footer = "Exit status: 0 when all runs are ok, 1 when not, or when a repeated row differs, 2 for an invalid "
        + "command, 130 after Ctrl+C.")
public final class SweepCommand implements Callable<Integer> {
    private static final int TIMEOUT_SECONDS = 30;
    /** Environment variable: the Python process ends when its standard input is closed, as by this one's end. */
    private static final String ENDS_WITH_INPUT = "SEAR_ENDS_WITH_INPUT";

    @Parameters(paramLabel = "SCRIPT.py", description = "A script as for sear SCRIPT.py. It reads "
        + "sear.getParameter(\"NAME\", default) and reports sear.setResult(\"NAME\", value).")
    private Path script;
    @Option(names = "--seeds", paramLabel = "N|A:B", description = "Number of seeds, from 1 on; or seeds A to "
        + "B. Default: 1.")
    private String seeds;
    @Option(names = "--set", paramLabel = "NAME=A:B:N|NAME=A,B,C", description = "Values of a parameter: N values from "
        + "A to B, or a list. May be given for several parameters; all combinations run.")
    private List<String> set;
    @Option(names = "--workers", paramLabel = "N", description = "Processes on this computer. Default: the number "
        + "of processors.")
    private String workers;
    @Option(names = "--scheduler", paramLabel = "ADDRESS", description = "Address of a running Dask scheduler, such as "
        + "tcp://host:8786.")
    private String scheduler;
    @Option(names = "--scheduler-file", paramLabel = "FILE", description = "File with a Dask scheduler's address.")
    private String schedulerFile;
    @Option(names = "--limit", paramLabel = "SECONDS", description = "Time limit of a run. Default: 600.")
    private String limit;
    @Option(names = "--memory", paramLabel = "MB", description = "Memory limit of a run's process. Default: none.")
    private String memory;
    @Option(names = "--out", paramLabel = "FOLDER", description = "Folder for the results; continues an interrupted "
        + "sweep there. Default: the script's name with -sweep.")
    private String out;
    @Option(names = "--fresh", description = "Discard existing results and start over.")
    private boolean fresh;
    @Option(names = "--again", paramLabel = "ROW", description = "Repeat only this row of a sweep and say whether its "
        + "result is the same.")
    private String again;
    @Option(names = "--python3", description = "Run the script with Python 3, whatever its first line.")
    private boolean python3;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        boolean windows = System.getProperty("os.name").toLowerCase(Locale.ROOT).startsWith("windows");
        String python = System.getenv().getOrDefault("SEAR_PYTHON", windows ? "python" : "python3");
        List<String> command = new ArrayList<>(List.of(python, "-u", "-m", "sear.sweeps", script.toString()));
        for (OptionSpec option : spec.options()) {
            if (option.getValue() instanceof List) {
                option.<List<String>>getValue().forEach(value -> command.add(option.longestName() + "=" + value));
            } else if (option.getValue() instanceof String) {
                command.add(option.longestName() + "=" + option.getValue());
            } else if (Boolean.TRUE.equals(option.getValue())) {
                command.add(option.longestName());
            }
        }
        ProcessBuilder builder = new ProcessBuilder(command).inheritIO().redirectInput(ProcessBuilder.Redirect.PIPE);
        builder.environment().put(ENDS_WITH_INPUT, "1");
        Path modules = Path.of(System.getProperty("sear.home", "."), "python");
        builder.environment().merge("PYTHONPATH", modules.toString(), (old, own) -> old + File.pathSeparator + own);
        try {
            Process process = builder.start();
            java.lang.Runtime.getRuntime().addShutdownHook(new Thread(() -> end(process), "sweep end"));
            return process.waitFor();
        } catch (IOException e) {
            PrintWriter err = spec.commandLine().getErr();
            err.println("sear sweep: there is no " + python + ": install Python 3.9 or newer, or set "
                + "SEAR_PYTHON to it");
            return ExitCode.SOFTWARE;
        }
    }

    /** Ends the Python process, which first writes its finished runs. Ctrl+C reaches both processes. */
    private static void end(Process process) {
        process.destroy();
        try {
            process.waitFor(TIMEOUT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
