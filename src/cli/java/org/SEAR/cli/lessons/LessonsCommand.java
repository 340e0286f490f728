// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code sear lessons}: lists the lessons. */
@Command(name = "lessons", mixinStandardHelpOptions = true, description = "Lists the lessons that come with SEAR.")
public final class LessonsCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        for (Lesson lesson : Lesson.all()) {
            out.printf("%-10s %s%n", lesson.getName(), lesson.title());
        }
        out.println();
        out.println("sear lesson NAME FOLDER copies one to a folder.");
        out.flush();
        return ExitCode.OK;
    }
}
