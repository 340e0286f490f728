// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.util.ArrayList;
import java.util.List;

/**
 * Options of MyRobotLab's own command line: {@code -c CONFIG} and {@code -s NAME TYPE NAME TYPE ...}, for example
 * {@code -s python Python sear SEAR}.
 */
public final class StartOptions {
    private static final String USAGE = "legal: -c CONFIG, -s NAME TYPE NAME TYPE ...";

    private final List<String[]> services = new ArrayList<>();
    private String config;

    /** @throws IllegalArgumentException if an option is unknown or has invalid values */
    public StartOptions(String... arguments) {
        int i = 0;
        while (i < arguments.length) {
            String option = arguments[i++];
            int first = i;
            while (i < arguments.length && !arguments[i].startsWith("-")) {
                i++;
            }
            take(option, List.of(arguments).subList(first, i));
        }
    }

    private void take(String option, List<String> values) {
        switch (option) {
            case "-c":
            case "--config":
                check(values.size() == 1, option + " needs the name of one configuration");
                config = values.get(0);
                break;
            case "-s":
            case "--service":
                check(!values.isEmpty() && values.size() % 2 == 0, option + " needs a name and a type for "
                    + "each service");
                for (int i = 0; i < values.size(); i += 2) {
                    services.add(new String[] {values.get(i), values.get(i + 1)});
                }
                break;
            case "-l":
            case "--log-level":
                throw new IllegalArgumentException(
                    option + ": give java the option -Dorg.slf4j.simpleLogger.defaultLogLevel=LEVEL instead");
            case "--id":
                throw new IllegalArgumentException(option + ": the id of the embedded MyRobotLab is always "
                    + Registry.ID);
            default:
                throw new IllegalArgumentException("option " + option + " is unknown, " + USAGE);
        }
    }

    private static void check(boolean right, String message) {
        if (!right) {
            throw new IllegalArgumentException(message + ", " + USAGE);
        }
    }

    /** Returns the name of the set of configuration files; null if not given. */
    public String getConfig() {
        return config;
    }

    /** Returns name and type of each service to start. */
    public List<String[]> getServices() {
        return services;
    }
}
