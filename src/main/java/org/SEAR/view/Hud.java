package org.SEAR.view;

import com.jme3.font.BitmapFont;
import com.jme3.math.ColorRGBA;
import com.jme3.scene.Node;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.raycast.Pose;

/** The words on the window: numbers of the simulation, warnings, messages, help. Window thread only. */
final class Hud {
    private static final ColorRGBA INK = new ColorRGBA(0.93f, 0.96f, 1, 1);
    private static final ColorRGBA AMBER = new ColorRGBA(1, 0.80f, 0.30f, 1);
    private static final float SIZE = 15;
    private static final float EDGE = 10;
    /** Real seconds between two updates of the numbers: faster can't be read. */
    private static final float REFRESH = 0.1f;
    /** Real seconds that a message stays. */
    private static final float STAY = 5;
    private static final int MESSAGES = 3;
    private static final int WARNINGS = 6;
    private static final double HUNDRED = 100;

    private final TextPanel status;
    private final TextPanel warnings;
    private final TextPanel messages;
    private final TextPanel help;
    private final TextPanel hint;
    private final Deque<String> recent = new ArrayDeque<>();
    private float sinceRefresh = REFRESH;
    private float sinceMessage;
    private boolean helpShown;
    private String statusWords = "";
    private String warningWords = "";

    Hud(BitmapFont font, Materials materials, Node gui) {
        status = panel(font, materials, gui, INK);
        warnings = panel(font, materials, gui, AMBER);
        messages = panel(font, materials, gui, INK);
        help = panel(font, materials, gui, INK);
        hint = panel(font, materials, gui, INK);
        hint.setText("F1 help");
    }

    private static TextPanel panel(BitmapFont font, Materials materials, Node gui, ColorRGBA color) {
        TextPanel panel = new TextPanel(font, materials, color, SIZE);
        gui.attachChild(panel.node());
        return panel;
    }

    /** What the status panel needs besides the moment. */
    static final class State {
        boolean paused;
        double measuredSpeed;
        double wantedSpeed;
        boolean flying;
        boolean scriptDrives;
        /** Robot that is followed. */
        int robot;
        /** Names of the beam sensors, in the order of their number keys. */
        List<String> beamSensors = List.of();
        /** Which of them are hidden. */
        List<String> hidden = List.of();
    }

    void update(float frameTime, int width, int height, Moment moment, State state) {
        sinceRefresh += frameTime;
        sinceMessage += frameTime;
        if (sinceMessage > STAY && !recent.isEmpty()) {
            recent.clear();
            messages.setText("");
        }
        if (sinceRefresh >= REFRESH) {
            sinceRefresh = 0;
            statusWords = status(moment, state);
            warningWords = warnings(moment);
            status.setText(helpShown ? "" : statusWords);
            warnings.setText(helpShown ? "" : warningWords);
        }
        status.place(EDGE, height - EDGE);
        warnings.place(EDGE, EDGE + warnings.height());
        messages.place((width - messages.width()) / 2, EDGE + messages.height());
        float fit = Math.min(1, (height - 2 * EDGE) / help.height());
        help.node().setLocalScale(fit);
        help.place((width - help.width() * fit) / 2, (height + help.height() * fit) / 2);
        hint.place(width - hint.width() - EDGE, EDGE + hint.height());
    }

    /** Shows a line for some seconds. */
    void say(String message) {
        recent.addLast(message);
        if (recent.size() > MESSAGES) {
            recent.removeFirst();
        }
        sinceMessage = 0;
        messages.setText(String.join("\n", recent));
    }

    void toggleHelp() {
        helpShown = !helpShown;
        help.setText(helpShown ? helpText() : "");
        hint.setText(helpShown ? "" : "F1 help");
        sinceRefresh = REFRESH;
    }

    boolean isHelpShown() {
        return helpShown;
    }

    String statusText() {
        return statusWords;
    }

    String warningsText() {
        return warningWords;
    }

    String messagesText() {
        return messages.text();
    }

    static String helpText() {
        StringBuilder text = new StringBuilder("Keys\n");
        for (Key key : Key.values()) {
            text.append(String.format("%s:  %s%n", key.label, key.help));
        }
        return text.append("Mouse:  drag turns the camera, wheel comes nearer").toString().replace("\r", "");
    }

    static String status(Moment moment, State state) {
        List<String> lines = new ArrayList<>();
        lines.add(String.format(Locale.ROOT, "time %.2f s   speed %.2f of %s%s", moment.time, state.measuredSpeed, factor(state.wantedSpeed),
            state.paused ? "   PAUSED" : ""));
        for (int i = 0; i < moment.robots.size(); i++) {
            lines.addAll(robot(moment.robots.get(i), moment.robots.size() > 1 && i == state.robot));
        }
        if (state.flying) {
            lines.add("flycam");
        }
        if (state.scriptDrives) {
            lines.add("a script drives: keys do not");
        }
        for (Map.Entry<String, String> value : moment.values.entrySet()) {
            int number = state.beamSensors.indexOf(value.getKey());
            String key = number < 0 || number > 8 ? "" : (number + 1) + "  ";
            lines.add(key + value.getKey() + ": " + value.getValue() + (state.hidden.contains(value.getKey()) ? "  (hidden)" : ""));
        }
        return String.join("\n", lines);
    }

    private static List<String> robot(Moment.RobotMoment robot, boolean followed) {
        Pose pose = robot.pose;
        List<String> lines = new ArrayList<>();
        lines.add(String.format(Locale.ROOT, "%s%s   x %.2f  y %.2f  z %.2f m   heading %.0f deg", followed ? "> " : "", robot.name,
            hundredths(pose.x), hundredths(pose.y), hundredths(pose.z), Math.rint(robot.heading()) + 0.0));
        lines.add(String.format(Locale.ROOT, "    %.2f m/s   %.0f deg/s", hundredths(robot.speed),
            Math.rint(Math.toDegrees(robot.turnRate)) + 0.0));
        for (String status : robot.status) {
            lines.add("    " + status);
        }
        return lines;
    }

    /** Rounded, and never a negative zero. */
    private static double hundredths(double value) {
        return Math.rint(value * HUNDRED) / HUNDRED + 0.0;
    }

    /** A speed factor as people write it. */
    static String factor(double factor) {
        return Double.isInfinite(factor) ? "max" : String.format(Locale.ROOT, factor < 1 ? "%.2f" : "%.0f", factor);
    }

    private static String warnings(Moment moment) {
        List<String> all = moment.warnings;
        return String.join("\n", all.subList(Math.max(0, all.size() - WARNINGS), all.size()));
    }
}
