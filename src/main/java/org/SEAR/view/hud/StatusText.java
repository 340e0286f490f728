// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.hud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.Snapshot;

/** Text of the window's panels. */
public final class StatusText {
    private static final int WARNINGS = 6;
    private static final double HUNDRED = 100;

    private StatusText() {
    }

    /** Returns time, robots and serial devices. */
    static String status(Snapshot snapshot, Hud.State state) {
        List<String> lines = new ArrayList<>();
        lines.add(String.format(Locale.ROOT, "time %.2f s   speed %.2f of %s%s", snapshot.time, state.measuredSpeed,
            factor(state.wantedSpeed), state.paused ? "   PAUSED" : ""));
        for (int i = 0; i < snapshot.robots.size(); i++) {
            lines.addAll(robot(snapshot.robots.get(i), snapshot.robots.size() > 1 && i == state.robot));
        }
        if (state.flying) {
            lines.add("flycam");
        }
        if (state.scriptDrives) {
            lines.add("a script drives: keys are off");
        }
        return String.join("\n", lines);
    }

    /** Returns all readings, with the number keys that show and hide beams. */
    static String sensors(Hud.State state) {
        List<String> lines = new ArrayList<>();
        for (Map.Entry<String, String> value : state.readings.entrySet()) {
            int number = state.beamSensors.indexOf(value.getKey());
            String key = number < 0 || number > 8 ? "" : (number + 1) + "  ";
            lines.add(key + value.getKey() + ": " + value.getValue()
                + (state.hidden.contains(value.getKey()) ? "  (hidden)" : ""));
        }
        return String.join("\n", lines);
    }

    private static List<String> robot(Snapshot.RobotState robot, boolean followed) {
        Pose pose = robot.pose;
        List<String> lines = new ArrayList<>();
        lines.add(String.format(Locale.ROOT, "%s%s   x %.2f  y %.2f  z %.2f m   heading %.0f deg", followed ? "> "
            : "", robot.name,
            hundredths(pose.x), hundredths(pose.y), hundredths(pose.z), Math.rint(pose.heading()) + 0.0));
        lines.add(String.format(Locale.ROOT, "    %.2f m/s   %.0f deg/s", hundredths(robot.speed),
            Math.rint(Math.toDegrees(robot.turnRate)) + 0.0));
        for (Snapshot.DeviceState device : robot.devices) {
            lines.add("    " + device);
        }
        return lines;
    }

    /** Rounds to hundredths and avoids negative zero. */
    private static double hundredths(double value) {
        return Math.rint(value * HUNDRED) / HUNDRED + 0.0;
    }

    /** Formats a speed factor. */
    public static String factor(double factor) {
        return Double.isInfinite(factor) ? "max" : String.format(Locale.ROOT, factor < 1 ? "%.2f" : "%.0f", factor);
    }

    /** Returns the latest warnings. */
    static String warnings(Snapshot snapshot) {
        List<String> all = snapshot.warnings;
        return String.join("\n", all.subList(Math.max(0, all.size() - WARNINGS), all.size()));
    }
}
