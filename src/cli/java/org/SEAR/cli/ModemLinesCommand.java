// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code sear modem-lines -- python3 my.py}: runs a program that sets DTR or RTS, which a pseudo-terminal lacks. */
@Command(name = "modem-lines", mixinStandardHelpOptions = true,
    description = "Runs a program with modem lines (DTR, RTS, CTS, DSR, CD) on pseudo-terminals. Drivers that switch "
    + "something by DTR, such as "
        + "the RPLIDAR's, fail without them. Setting a line has no effect. Linux only; needs a C compiler (cc).",
    footer = "Exit status: the program's.")
final class ModemLinesCommand implements Callable<Integer> {
    private static final String PRELOAD = "LD_PRELOAD";

    @Parameters(arity = "1..*", paramLabel = "PROGRAM", description = "The program and its arguments, after --.")
    private List<String> program;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        PrintWriter err = spec.commandLine().getErr();
        if (!System.getProperty("os.name").toLowerCase(Locale.ROOT).contains("linux")) {
            err.println("sear: modem-lines needs Linux; elsewhere use sear.exportRfc2217, which supports DTR and RTS");
            return ExitCode.USAGE;
        }
        try (ModemLines lines = ModemLines.compile("cc")) {
            return run(lines);
        } catch (IOException e) {
            err.println("sear: " + e.getMessage());
            return ExitCode.USAGE;
        }
    }

    /** Runs the program on this terminal; the program ends with this process. */
    private int run(ModemLines lines) throws IOException, InterruptedException {
        ProcessBuilder builder = new ProcessBuilder(program).inheritIO();
        builder.environment().merge(PRELOAD, lines.getLibrary().toString(), (before, own) -> own + ":" + before);
        Process process;
        try {
            process = builder.start();
        } catch (IOException e) {
            throw new IOException("the program can't be started: " + e.getMessage(), e);
        }
        Thread ending = new Thread(process::destroy);
        java.lang.Runtime.getRuntime().addShutdownHook(ending);
        return process.waitFor();
    }
}
