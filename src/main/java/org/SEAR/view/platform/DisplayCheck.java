package org.SEAR.view.platform;

import java.util.Locale;
import java.util.Map;

/** Finds out without touching a native library whether there can't be a window. */
public final class DisplayCheck {
    private DisplayCheck() {
    }

    /** Whether a window has to run on its process's first thread: macOS. */
    public static boolean needsFirstThread() {
        return isMac(System.getProperty("os.name", ""));
    }

    private static boolean isMac(String system) {
        String os = system.toLowerCase(Locale.ROOT);
        return os.contains("mac") || os.contains("darwin");
    }

    /** Why this process can't have a window; null if it may. */
    public static String problem() {
        return problem(System.getProperty("os.name", ""), System.getenv());
    }

    public static String problem(String system, Map<String, String> environment) {
        boolean windows = system.toLowerCase(Locale.ROOT).startsWith("win");
        if (!windows && !isMac(system) && environment.getOrDefault("DISPLAY", "").isEmpty()
                && environment.getOrDefault("WAYLAND_DISPLAY", "").isEmpty()) {
            return "there is no display (DISPLAY is not set)";
        }
        return null;
    }
}
