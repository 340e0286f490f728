// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.platform;

import java.util.Locale;
import java.util.Map;

/** Detects, without native libraries, whether a window is impossible. */
public final class DisplayCheck {
    private DisplayCheck() {
    }

    /** Returns whether a window must run on the process's first thread (macOS). */
    public static boolean needsFirstThread() {
        return isMac(System.getProperty("os.name", ""));
    }

    private static boolean isMac(String system) {
        String os = system.toLowerCase(Locale.ROOT);
        return os.contains("mac") || os.contains("darwin");
    }

    /** Returns why this process can't open a window, or null. */
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
