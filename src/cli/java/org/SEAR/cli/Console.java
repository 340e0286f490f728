package org.SEAR.cli;

/**
 * What of the log is seen on the console: warnings, errors and the progress of long work, each as {@code [WARN] service: text}.
 * What is set from outside wins.
 */
final class Console {
    /** The logger of what takes long. */
    private static final String PROGRESS = "org.SEAR.progress";
    private static final String PREFIX = "org.slf4j.simpleLogger.";

    private Console() {
    }

    /** Before the first logger is made. */
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
