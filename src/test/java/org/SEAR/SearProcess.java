package org.SEAR;

import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The command {@code sear} from the compiled classes, in a JVM of its own. */
public final class SearProcess {
    private SearProcess() {
    }

    /**
     * Its command line, for the arguments of {@code sear} to be added. It leaves out the optimizing compiler, whose work does not pay for programs
     * that end after seconds.
     *
     * @param options of the JVM
     * @return a list that can grow
     */
    public static List<String> command(String... options) {
        return command(System.getProperty("sear.cliClasspath"), options);
    }

    /** The same with another class path. */
    public static List<String> command(String classPath, String[] options) {
        List<String> command = new ArrayList<>(List.of(Paths.get(System.getProperty("java.home"), "bin", "java").toString(), "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1"));
        command.addAll(Arrays.asList(options));
        command.addAll(List.of("-cp", classPath, "org.SEAR.cli.SearCommand"));
        return command;
    }
}
