// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import org.SEAR.cli.classroom.ClassCommand;
import org.SEAR.cli.contests.ContestCommand;
import org.SEAR.cli.install.InstallCommand;
import org.SEAR.cli.lessons.GradeCommand;
import org.SEAR.cli.lessons.LessonCommand;
import org.SEAR.cli.lessons.LessonsCommand;
import org.SEAR.cli.sweep.SweepCommand;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.simulator.SimulationRunner;
import org.myrobotlab.embedded.NearestName;
import org.myrobotlab.embedded.python.JythonStart;
import org.myrobotlab.embedded.python3.Python3Script;
import org.myrobotlab.service.sear.files.ExampleBundles;
import org.myrobotlab.service.sear.run.RunParameters;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import picocli.CommandLine;

/** {@code sear SCRIPT.py [options]}, and the other commands of the program. */
@Command(name = "sear", mixinStandardHelpOptions = true, versionProvider = Version.class,
    subcommands = {CheckCommand.class, ScriptCommand.class, ImportCommand.class, SensorsCommand.class,
        ModemLinesCommand.class, InstallCommand.class,
        LessonsCommand.class, LessonCommand.class, GradeCommand.class, SweepCommand.class, ClassCommand.class,
        ContestCommand.class, AutoComplete.GenerateCompletion.class, HelpCommand.class},
    description = "Runs a Python script in a small MyRobotLab with SEAR, or opens a project in the tabs and "
        + "in a browser. A script's project is the folder SEARproject in the working folder.",
    footer = "Exit status: 0 when the script ends, 1 when it raises an error, 2 for an invalid command.")
public final class SearCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "SCRIPT.py|-|PROJECT", arity = "0..1", description = "A script in Python 2.7"
        + " (Jython, as in MyRobotLab), - for one from the standard input; or a bundle (.sear) or folder to open in "
        + "the tabs. Examples are found from any folder. Without it the tabs show the working folder's project.")
    private Path script;
    @Parameters(index = "1..*", paramLabel = "ARGUMENT", arity = "0..*", description = "Arguments of the script, in "
        + "sys.argv. Put -- before the first one if any looks like an option or a command.")
    private List<String> arguments = List.of();
    @Option(names = "--headless", description = "Open no window.")
    private boolean headless;
    @Option(names = "--speed", paramLabel = "FACTOR|max", description = "Simulated seconds per second; max: as fast as "
        + "possible, in lock-step with the script and repeatable. Default: 1.")
    private String speed;
    @Option(names = "--seed", paramLabel = "N", description = "Seed of the sensors' random numbers, a whole number.")
    private Long seed;
    @Option(names = "--set", paramLabel = "NAME=VALUE", description = "A parameter of the script, read by "
        + "sear.getParameter(\"NAME\", default). May be given several times.")
    private List<String> parameters = List.of();
    @Option(names = "--threads", paramLabel = "N", description = "Threads for sensors and cameras, 1 to 256; does not "
        + "change the readings. Default: the number of processors.")
    private String threads;
    @Option(names = "--port", paramLabel = "N|none", defaultValue = "8888", description = "Port of the tabs in the "
        + "browser: http://localhost:N. Default: ${DEFAULT-VALUE}.")
    private String port;
    @Mixin
    private ServerOptions server = new ServerOptions();
    @Option(names = "--record", paramLabel = "FILE", description = "Record the script's simulations to this file, in "
        + "addition to the script's own recordings. The file keeps the last simulation.")
    private String record;
    @Option(names = "--until", paramLabel = "SECONDS", description = "End the script after this simulated time.")
    private Double until;
    @Option(names = "--python3", description = "Run the script with python3 and the package sear. Scripts whose first "
        + "line is #!/usr/bin/env python3 need no option.")
    private boolean python3;
    @Option(names = "--keep", description = "Keep running after the script's end, until Ctrl+C or Runtime.shutdown().")
    private boolean keep;
    @Spec
    private CommandSpec spec;

    public static void main(String[] arguments) {
        Console.quiet();
        if (arguments.length == 0 || Arrays.stream(arguments)
            .anyMatch(one -> one.endsWith(".py") || one.endsWith(".sear") || one.equals("-"))) {
            JythonStart.begin();
        }
        int status = commandLine().execute(arguments);
        System.out.flush();
        System.exit(status);
    }

    /** Returns the whole command line, for main and for tests. */
    static CommandLine commandLine() {
        CommandLine line = new CommandLine(new SearCommand());
        line.getSubcommands().get("modem-lines").setStopAtPositional(true);
        CommandHelp.apply(line);
        return line;
    }

    @Override
    public Integer call() throws Exception {
        if (headless) {
            System.setProperty("sear.headless", "true");
        }
        if (speed != null) {
            System.setProperty("sear.speed", checkedSpeed());
        }
        if (seed != null) {
            System.setProperty("sear.seed", seed.toString());
        }
        if (threads != null) {
            System.setProperty("sear.threads", checkedThreads());
        }
        for (String one : parameters) {
            set(one);
        }
        if (record != null) {
            System.setProperty("sear.record", record);
        }
        System.setProperty(Python3Script.ALWAYS, String.valueOf(python3));
        System.setProperty("sear.keep", String.valueOf(keep));
        PrintWriter err = spec.commandLine().getErr();
        server.apply(spec);
        MrlRun run = new MrlRun(checkedPort(), server.isKnown(), err);
        if (script != null && script.toString().equals("-")) {
            script = fromInput();
        }
        if (script != null && !Files.exists(script) && !ExampleBundles.isMeant(script)) {
            String meant = NearestName.of(script.toString(), spec.subcommands().keySet());
            err.println("sear: " + script + " can't be read: there is no such file. "
                + (meant.isEmpty() ? "" : "If it is a command, " + meant + " ") + "Try sear --help.");
            return CommandLine.ExitCode.USAGE;
        }
        if (script == null || Files.isDirectory(script) || script.toString().endsWith(".sear")) {
            return run.project(script, !headless);
        }
        int status = run.script(script, arguments, keep, checkedUntil());
        if (status == CommandLine.ExitCode.OK) {
            RunParameters.unasked().forEach(name -> err.println("sear: the script did not read parameter " + name
                + ": check its name in sear.getParameter"));
        }
        return status;
    }

    /** Returns a temporary file with the script of the standard input. */
    private static Path fromInput() throws IOException {
        Path file = Files.createTempDirectory("sear").resolve("stdin.py");
        file.getParent().toFile().deleteOnExit();
        file.toFile().deleteOnExit();
        Files.write(file, System.in.readAllBytes());
        return file;
    }

    private void set(String parameter) {
        int end = parameter.indexOf('=');
        if (end < 0 || !RunParameters.isLegal(parameter.substring(0, end))) {
            throw new ParameterException(spec.commandLine(), "--set is \"" + parameter
                + "\", legal: NAME=VALUE, with a name of " + RunParameters.LEGAL_NAME);
        }
        System.setProperty(RunParameters.PROPERTY + parameter.substring(0, end), parameter.substring(end + 1));
    }

    private String checkedSpeed() {
        if (!speed.equals("max") && !(speed.matches("[0-9]*\\.?[0-9]+")
            && Double.parseDouble(speed) >= SimulationRunner.SLOWEST)) {
            throw new ParameterException(spec.commandLine(), "--speed is \"" + speed + "\", legal: a number of "
                + SimulationRunner.SLOWEST + " or more, or max");
        }
        return speed;
    }

    private double checkedUntil() {
        if (until != null && !(until > 0)) {
            throw new ParameterException(spec.commandLine(), "--until is " + until + ", legal: above 0");
        }
        return until == null ? Double.POSITIVE_INFINITY : until;
    }

    private String checkedThreads() {
        if (!WorkerPool.isLegal(threads)) {
            throw new ParameterException(spec.commandLine(), "--threads is \"" + threads + "\", legal: "
                + WorkerPool.LEGAL);
        }
        return threads;
    }

    private int checkedPort() {
        if (port.equals("none")) {
            return MrlRun.NO_PORT;
        }
        if (!port.matches("[0-9]{1,5}") || Integer.parseInt(port) < 1 || Integer.parseInt(port) > MrlRun.HIGHEST_PORT) {
            throw new ParameterException(spec.commandLine(), "--port is \"" + port + "\", legal: 1 to "
                + MrlRun.HIGHEST_PORT + ", or none");
        }
        return Integer.parseInt(port);
    }
}
