// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

/**
 * Log output on the console: warnings, errors and progress of long work, each as {@code [WARN] service: text}. System
 * properties set by the user win.
 */
final class Console {
    /** Logger of progress messages. */
    private static final String PROGRESS = "org.SEAR.progress";
    private static final String PREFIX = "org.slf4j.simpleLogger.";

    private Console() {
    }

    /** Configures the log; must run before the first logger exists. */
    static void quiet() {
        set("defaultLogLevel", "warn");
        set("log." + PROGRESS, "info");
        set("showThreadName", "false");
        set("showLogName", "false");
        set("levelInBrackets", "true");
        System.setProperty("java.util.logging.SimpleFormatter.format", "[%4$s] %5$s%n");
        java.util.logging.Logger.getLogger("").setLevel(java.util.logging.Level.WARNING);
    }

    private static void set(String name, String value) {
        if (System.getProperty(PREFIX + name) == null) {
            System.setProperty(PREFIX + name, value);
        }
    }
}
