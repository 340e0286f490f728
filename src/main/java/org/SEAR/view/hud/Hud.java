// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.hud;

import com.jme3.font.BitmapFont;
import com.jme3.math.ColorRGBA;
import com.jme3.scene.Node;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import org.SEAR.simulator.Snapshot;
import org.SEAR.view.input.Key;
import org.SEAR.view.link.CameraFrame;
import org.SEAR.view.scene.Materials;

/** Text on the window: simulation data, warnings, messages, help. Window thread only. */
public final class Hud {
    private static final ColorRGBA INK = new ColorRGBA(0.93f, 0.96f, 1, 1);
    private static final ColorRGBA AMBER = new ColorRGBA(1, 0.80f, 0.30f, 1);
    private static final float SIZE = 15;
    private static final float EDGE = 10;
    /** Minimum scale of panels. */
    private static final float SMALLEST = 0.6f;
    /** Real seconds between two updates of the numbers, for readability. */
    private static final float REFRESH = 0.1f;
    /** Real seconds for which a message is shown. */
    private static final float STAY = 5;
    private static final int MESSAGES = 3;

    private final TextPanel status;
    private final TextPanel sensors;
    private final TextPanel warnings;
    private final TextPanel messages;
    private final TextPanel help;
    private final TextPanel hint;
    private final CameraPanel camera;
    private final Deque<String> recent = new ArrayDeque<>();
    private float sinceRefresh = REFRESH;
    private float sinceMessage;
    private boolean helpShown;
    private boolean folded;
    private boolean cameras;
    private String statusWords = "";
    private String sensorWords = "";
    private String warningWords = "";

    public Hud(BitmapFont font, Materials materials, Node gui) {
        status = panel(font, materials, gui, INK);
        sensors = panel(font, materials, gui, INK);
        warnings = panel(font, materials, gui, AMBER);
        messages = panel(font, materials, gui, INK);
        help = panel(font, materials, gui, INK);
        hint = panel(font, materials, gui, INK);
        hint.setText(hintText());
        camera = new CameraPanel(font, materials, gui, INK, SIZE);
    }

    private static TextPanel panel(BitmapFont font, Materials materials, Node gui, ColorRGBA color) {
        TextPanel panel = new TextPanel(font, materials, color, SIZE);
        gui.attachChild(panel.node());
        return panel;
    }

    /** Input of the status panel besides the scene's state. */
    public static final class State {
        public boolean paused;
        public double measuredSpeed;
        public double wantedSpeed;
        public boolean flying;
        public boolean scriptDrives;
        /** Number of the followed robot. */
        public int robot;
        /** Names of the beam sensors in the order of their number keys. */
        public List<String> beamSensors = List.of();
        /** Whether any robot has a camera. */
        public boolean hasCameras;
        /** Name of the camera whose picture is shown, or null. */
        public String camera;
        /** That camera's picture, or null. */
        public CameraFrame picture;
        /** Readings as text with unit, by sensor name. */
        public Map<String, String> readings = Map.of();
        /** Names of the beam sensors whose beams are hidden. */
        public List<String> hidden = List.of();
    }

    public void update(float frameTime, int width, int height, Snapshot snapshot, State state) {
        if (state.hasCameras != cameras) {
            cameras = state.hasCameras;
            hint.setText(hintText());
        }
        camera.show(helpShown ? null : state.picture, helpShown ? null : state.camera);
        sinceRefresh += frameTime;
        sinceMessage += frameTime;
        if (sinceMessage > STAY && !recent.isEmpty()) {
            recent.clear();
            messages.setText("");
        }
        if (sinceRefresh >= REFRESH) {
            sinceRefresh = 0;
            statusWords = StatusText.status(snapshot, state);
            sensorWords = StatusText.sensors(state);
            warningWords = StatusText.warnings(snapshot);
            status.setText(helpShown ? "" : folded ? statusWords.split("\n", 2)[0] : statusWords);
            sensors.setText(helpShown || folded ? "" : sensorWords);
            warnings.setText(helpShown ? "" : warningWords);
        }
        place(width, height);
    }

    /**
     * Places numbers at the top and text at the bottom. Panels that don't fit side by side shrink, or are placed above
     * each other.
     */
    private void place(int width, int height) {
        float fit = Math.min(1, (width - 3 * EDGE) / (status.width() + sensors.width()));
        boolean beside = fit >= SMALLEST;
        float scale = beside ? fit : 1;
        status.node().setLocalScale(scale);
        sensors.node().setLocalScale(scale);
        status.place(EDGE, height - EDGE);
        sensors.place(beside ? width - sensors.width() * scale - EDGE : EDGE,
            height - EDGE - (beside ? 0 : status.height() + EDGE));
        warnings.place(EDGE, EDGE + warnings.height());
        float middle = (width - messages.width()) / 2;
        boolean clear = warningWords.isEmpty() || EDGE + warnings.width() < middle;
        messages.place(middle, EDGE + messages.height() + (clear ? 0 : warnings.height() + EDGE));
        float helpScale = Math.min(1, (height - 2 * EDGE) / help.height());
        help.node().setLocalScale(helpScale);
        help.place((width - help.width() * helpScale) / 2, (height + help.height() * helpScale) / 2);
        boolean beneath = warningWords.isEmpty() || EDGE + warnings.width() < width - hint.width() - EDGE;
        float above = EDGE + hint.height() + (beneath ? 0 : warnings.height() + EDGE);
        hint.place(width - hint.width() - EDGE, above);
        camera.place(width, height, EDGE, above + EDGE);
    }

    /** Shows a line for {@link #STAY} seconds. */
    public void say(String message) {
        recent.addLast(message);
        if (recent.size() > MESSAGES) {
            recent.removeFirst();
        }
        sinceMessage = 0;
        messages.setText(String.join("\n", recent));
    }

    public void toggleHelp() {
        helpShown = !helpShown;
        help.setText(helpShown ? helpText() : "");
        hint.setText(hintText());
        sinceRefresh = REFRESH;
    }

    /** Toggles between all numbers and the line with the time. Warnings and messages stay. */
    public void toggleFolded() {
        folded = !folded;
        hint.setText(hintText());
        sinceRefresh = REFRESH;
    }

    private String hintText() {
        return helpShown ? "" : (folded ? "F4 numbers   " : "") + (cameras ? "F6 cameras   " : "") + "F1 help";
    }

    /** Returns the visible text of the number panels. */
    public String shownText() {
        return (status.text() + "\n" + sensors.text()).trim();
    }

    public boolean isHelpShown() {
        return helpShown;
    }

    public String statusText() {
        return statusWords + "\n" + sensorWords;
    }

    /** Returns the camera panel. */
    public CameraPanel camera() {
        return camera;
    }

    public String messagesText() {
        return messages.text();
    }

    public static String helpText() {
        StringBuilder text = new StringBuilder("Keys\n");
        for (Key key : Key.values()) {
            text.append(String.format("%s\t%s%n", key.label, key.help));
        }
        return text.append("Mouse\tdrag turns the camera, wheel zooms").toString().replace("\r", "");
    }
}
