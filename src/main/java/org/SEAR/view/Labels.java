package org.SEAR.view;

import com.jme3.font.BitmapFont;
import com.jme3.font.BitmapText;
import com.jme3.math.ColorRGBA;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Names with live values, written at points of the world. Window thread only. */
final class Labels {
    private static final float SIZE = 14;
    private static final float LIFT = 20;
    private static final float LINE = 18;
    private static final ColorRGBA INK = new ColorRGBA(1, 1, 0.85f, 1);
    private static final ColorRGBA EDGE = new ColorRGBA(0, 0, 0, 0.85f);
    private final BitmapFont font;
    private final Node node = new Node("labels");
    private final Map<String, Label> labels = new LinkedHashMap<>();
    /** Left, bottom, right edge of each label placed in this picture. */
    private final List<float[]> taken = new ArrayList<>();
    private boolean shown = true;

    /** Ink with an edge beneath, so that it can be read on any ground. */
    private final class Label {
        final Node place = new Node("label");
        final BitmapText ink = text(INK, 0, 0, 1);
        final BitmapText edge = text(EDGE, 1, -1, 0);

        private BitmapText text(ColorRGBA color, float right, float up, float front) {
            BitmapText text = new BitmapText(font);
            text.setSize(SIZE);
            text.setColor(color);
            text.setLocalTranslation(right, up, front);
            place.attachChild(text);
            return text;
        }
    }

    Labels(BitmapFont font, Node gui) {
        this.font = font;
        gui.attachChild(node);
    }

    void toggle() {
        shown = !shown;
        node.setCullHint(shown ? CullHint.Never : CullHint.Always);
    }

    boolean isShown() {
        return shown;
    }

    /** Words of a label; null when there is none or it is hidden. */
    String text(String name) {
        Label label = labels.get(name);
        return label == null || !shown || label.place.getLocalCullHint() == CullHint.Always ? null : label.ink.getText();
    }

    /** Begins a new picture: places are free again. */
    void begin() {
        taken.clear();
    }

    /** Writes words at a point, above what is there; hides them while the point is behind the camera. @param words null to hide */
    void put(String name, String words, Vector3f point, Camera camera) {
        Label label = labels.computeIfAbsent(name, key -> {
            Label made = new Label();
            node.attachChild(made.place);
            return made;
        });
        Vector3f pixel = camera.getScreenCoordinates(point);
        boolean visible = words != null && pixel.z < 1;
        label.place.setCullHint(visible ? CullHint.Never : CullHint.Always);
        if (visible) {
            if (!words.equals(label.ink.getText())) {
                label.ink.setText(words);
                label.edge.setText(words);
            }
            float width = label.ink.getLineWidth();
            float left = Math.round(pixel.x - width / 2);
            label.place.setLocalTranslation(left, free(left, left + width, Math.round(pixel.y + LIFT)), -2);
        }
    }

    /** The lowest free height at or above the wanted one. */
    private float free(float left, float right, float wanted) {
        float bottom = wanted;
        for (boolean clash = true; clash;) {
            clash = false;
            for (float[] other : taken) {
                if (left < other[2] && right > other[0] && Math.abs(bottom - other[1]) < LINE) {
                    bottom = other[1] + LINE;
                    clash = true;
                }
            }
        }
        taken.add(new float[] {left, bottom, right});
        return bottom;
    }
}
