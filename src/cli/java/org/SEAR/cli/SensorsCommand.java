// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.sensors.SensorType;
import org.SEAR.sensors.SensorTypes;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code sear sensors}: the sensor types with parameters, units, ranges and defaults. */
@Command(name = "sensors", mixinStandardHelpOptions = true,
    description = "Prints the sensor types with their parameters, units, legal ranges and defaults.")
final class SensorsCommand implements Callable<Integer> {
    private static final int DEEPEST = 3;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        PrintWriter out = spec.commandLine().getOut();
        for (SensorType type : SensorTypes.load().all()) {
            out.println(type.parameterType().getSimpleName() + ": " + type.description());
            print(out, ParameterTable.of(type.parameterType()), 1);
            out.println();
        }
        return ExitCode.OK;
    }

    private static void print(PrintWriter out, ParameterTable table, int depth) {
        String indent = "  ".repeat(depth);
        for (Parameter parameter : table.getParameters()) {
            String standard = table.defaultOf(parameter);
            boolean isGroup = parameter.getKind() == Parameter.Kind.GROUP;
            out.println(indent + parameter.getName() + ": " + parameter.getDoc() + ". " + legal(parameter, isGroup)
                + (standard.isEmpty() || isGroup ? "" : "; default " + standard));
            if (isGroup && depth < DEEPEST) {
                print(out, ParameterTable.of(parameter.getType()), depth + 1);
            }
        }
    }

    private static String legal(Parameter parameter, boolean isGroup) {
        String many = parameter.isList() ? "Up to " + parameter.getMaxEntries() + ", each " : "Legal: ";
        return isGroup ? many + "a group:" : many + parameter.legal() + (parameter.isRequired() ? ", required" : "");
    }
}
