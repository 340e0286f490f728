// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import java.io.File;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The command {@code sear} from the compiled classes, in its own JVM. */
public final class SearProcess {
    private SearProcess() {
    }

    /**
     * Returns the command line, to which the arguments of {@code sear} are added. It turns off the optimizing compiler,
     * which does not pay off within seconds, and loads classes from the archive of {@code ./gradlew classArchive}.
     * @param options of the JVM
     * @return a list that can grow
     */
    public static List<String> command(String... options) {
        return command("", options);
    }

    /**
     * Returns the command line with a longer class path.
     * @param moreClasses appended to the class path; empty for nothing
     */
    public static List<String> command(String moreClasses, String[] options) {
        List<String> command = java(moreClasses, options);
        command.add("org.SEAR.cli.SearCommand");
        return command;
    }

    /** Returns the command line for another main class; its name is the first argument to add. */
    public static List<String> java(String moreClasses, String[] options) {
        List<String> command = new ArrayList<>(
            List.of(Paths.get(System.getProperty("java.home"), "bin", "java").toString(), "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1"));
        String archive = System.getProperty("sear.classArchive");
        if (archive != null) {
            command.addAll(List.of("-XX:+UnlockDiagnosticVMOptions", "-XX:ArchiveRelocationMode=0",
                "-XX:SharedArchiveFile=" + archive));
        }
        command.addAll(Arrays.asList(options));
        String classPath = System.getProperty(archive != null ? "sear.cliJars" : "sear.cliClasspath");
        command.addAll(List.of("-cp", moreClasses.isEmpty() ? classPath : classPath + File.pathSeparator
            + moreClasses));
        return command;
    }
}
