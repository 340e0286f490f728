package org.SEAR;

import java.io.File;
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
     * that end after seconds, and takes the classes from the archive that {@code ./gradlew classArchive} has written.
     *
     * @param options of the JVM
     * @return a list that can grow
     */
    public static List<String> command(String... options) {
        return command("", options);
    }

    /**
     * The same with more than what comes with SEAR.
     *
     * @param moreClasses what else is on the class path, at its end; empty for nothing
     */
    public static List<String> command(String moreClasses, String[] options) {
        List<String> command = java(moreClasses, options);
        command.add("org.SEAR.cli.SearCommand");
        return command;
    }

    /** The same for another main class, whose name is the first to be added. */
    public static List<String> java(String moreClasses, String[] options) {
        List<String> command = new ArrayList<>(List.of(Paths.get(System.getProperty("java.home"), "bin", "java").toString(), "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1"));
        String archive = System.getProperty("sear.classArchive");
        if (archive != null) {
            command.addAll(List.of("-XX:+UnlockDiagnosticVMOptions", "-XX:ArchiveRelocationMode=0", "-XX:SharedArchiveFile=" + archive));
        }
        command.addAll(Arrays.asList(options));
        String classPath = System.getProperty(archive != null ? "sear.cliJars" : "sear.cliClasspath");
        command.addAll(List.of("-cp", moreClasses.isEmpty() ? classPath : classPath + File.pathSeparator + moreClasses));
        return command;
    }
}
