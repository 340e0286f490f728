// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.myrobotlab.embedded.NearestName;
import picocli.CommandLine;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Help in groups, and answers to invalid commands in two lines. */
final class CommandHelp {
    private static final Map<String, Set<String>> OPTIONS = new LinkedHashMap<>();
    private static final Map<String, Set<String>> COMMANDS = new LinkedHashMap<>();

    static {
        OPTIONS.put("The run:", Set.of("--headless", "--speed", "--until", "--record", "--keep", "--python3"));
        OPTIONS.put("What changes the readings:", Set.of("--seed", "--set", "--threads"));
        OPTIONS.put("The tabs in the browser:", Set.of("--port", "--host", "--url", "--token", "--token-file"));
        OPTIONS.put("About sear:", Set.of("--help", "--version"));
        COMMANDS.put("Commands for projects:", Set.of("check", "script", "import", "sensors"));
        COMMANDS.put("Commands for many runs:", Set.of("sweep", "contest"));
        COMMANDS.put("Commands for teaching:", Set.of("lessons", "lesson", "grade", "class"));
        COMMANDS.put("Commands for this computer:", Set.of("install", "modem-lines", "generate-completion", "help"));
    }

    private CommandHelp() {
    }

    /** Sets help and error messages of a command line and its commands. */
    static void apply(CommandLine line) {
        line.setParameterExceptionHandler((error, arguments) -> answer(error));
        Map<String, CommandLine.IHelpSectionRenderer> sections = line.getHelpSectionMap();
        sections.put(UsageMessageSpec.SECTION_KEY_OPTION_LIST_HEADING, help -> "");
        sections.put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, CommandHelp::options);
        sections.put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST_HEADING, help -> "");
        sections.put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST, CommandHelp::commands);
        line.setHelpSectionMap(sections);
    }

    private static String options(Help help) {
        StringBuilder text = new StringBuilder();
        List<OptionSpec> rest = new ArrayList<>(help.commandSpec().options());
        for (Map.Entry<String, Set<String>> group : OPTIONS.entrySet()) {
            List<OptionSpec> some = rest.stream().filter(one -> group.getValue().contains(one.longestName()))
                .collect(Collectors.toList());
            rest.removeAll(some);
            text.append(list(help, group.getKey(), some));
        }
        return text + list(help, "Others:", rest);
    }

    private static String list(Help help, String heading, List<OptionSpec> options) {
        if (options.isEmpty()) {
            return "";
        }
        Help.Layout layout = help.createDefaultLayout();
        layout.addOptions(options, help.parameterLabelRenderer());
        return heading + System.lineSeparator() + layout;
    }

    private static String commands(Help help) {
        StringBuilder text = new StringBuilder();
        Map<String, Help> rest = new LinkedHashMap<>(help.subcommands());
        for (Map.Entry<String, Set<String>> group : COMMANDS.entrySet()) {
            Map<String, Help> some = new LinkedHashMap<>(rest);
            some.keySet().retainAll(group.getValue());
            rest.keySet().removeAll(group.getValue());
            text.append(some.isEmpty() ? "" : group.getKey() + System.lineSeparator() + help.commandList(some));
        }
        return text + (rest.isEmpty() ? "" : "Other commands:" + System.lineSeparator() + help.commandList(rest));
    }

    /** Prints the error with the nearest option, and where to read on. */
    private static int answer(ParameterException error) {
        CommandLine line = error.getCommandLine();
        String name = line.getCommandSpec().qualifiedName();
        String meant = "";
        if (error instanceof UnmatchedArgumentException) {
            String wrong = ((UnmatchedArgumentException) error).getUnmatched().get(0);
            String question = NearestName.of(wrong.replaceFirst("=.*", ""),
                new TreeSet<>(line.getCommandSpec().optionsMap().keySet()));
            meant = question.isEmpty() ? "" : ": " + question;
        }
        line.getErr().println(name + ": " + error.getMessage() + meant);
        line.getErr().println("Try " + name + " --help.");
        return ExitCode.USAGE;
    }
}
