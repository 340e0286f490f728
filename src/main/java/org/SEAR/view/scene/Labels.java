// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.font.BitmapFont;
import com.jme3.font.BitmapText;
import com.jme3.math.ColorRGBA;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.shape.Quad;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Names with live values at points of the world. Window thread only. */
public final class Labels {
    private static final float SIZE = 14;
    private static final float LIFT = 20;
    private static final float LINE = 18;
    /**
     * Maximum lines by which a label moves up to avoid others. Beyond that it is hidden, as its object would be
     * unclear.
     */
    private static final int MAX_LINES = 2;
    private static final ColorRGBA INK = new ColorRGBA(1, 1, 0.85f, 1);
    private static final ColorRGBA GROUND = new ColorRGBA(0.05f, 0.07f, 0.10f, 0.5f);
    private static final float MARGIN = 4;
    private final BitmapFont font;
    private final Materials materials;
    private final Node node = new Node("labels");
    private final Map<String, Label> labels = new LinkedHashMap<>();
    /** Left, bottom and right edge of each label in this frame. */
    private final List<float[]> taken = new ArrayList<>();
    private boolean shown = true;
    private boolean covered;

    /** Text on a dark translucent background, readable in front of beams. */
    private final class Label {
        final Node place = new Node("label");
        final BitmapText ink = new BitmapText(font);
        final Geometry ground = new Geometry("ground", new Quad(1, 1));

        Label() {
            ink.setSize(SIZE);
            ink.setColor(INK);
            ground.setMaterial(materials.flat(GROUND));
            place.attachChild(ground);
            place.attachChild(ink);
        }

        void write(String words) {
            ink.setText(words);
            ground.setLocalScale(ink.getLineWidth() + 2 * MARGIN, LINE, 1);
            ground.setLocalTranslation(-MARGIN, -LINE, -0.5f);
        }
    }

    public Labels(BitmapFont font, Materials materials, Node gui) {
        this.font = font;
        this.materials = materials;
        gui.attachChild(node);
    }

    public void toggle() {
        shown = !shown;
        show();
    }

    /** Hides labels while a panel covers them. */
    public void setCovered(boolean on) {
        covered = on;
        show();
    }

    private void show() {
        node.setCullHint(shown && !covered ? CullHint.Never : CullHint.Always);
    }

    /** Returns the text of a label; null if it is missing or hidden. */
    public String text(String name) {
        Label label = labels.get(name);
        return label == null || !shown || label.place.getLocalCullHint() == CullHint.Always ? null
            : label.ink.getText();
    }

    /** Begins a frame without labels. */
    void begin() {
        taken.clear();
    }

    /**
     * Places a label at a point, above other labels. Hides it if the point is behind the camera or the label would move
     * up too far.
     * @param words text, or null to hide
     */
    void put(String name, String words, Vector3f point, Camera camera) {
        Label label = labels.computeIfAbsent(name, key -> {
            Label made = new Label();
            node.attachChild(made.place);
            return made;
        });
        Vector3f pixel = camera.getScreenCoordinates(point);
        boolean visible = words != null && pixel.z < 1;
        if (visible) {
            if (!words.equals(label.ink.getText())) {
                label.write(words);
            }
            float width = label.ink.getLineWidth();
            float left = Math.round(pixel.x - width / 2);
            float wanted = Math.round(pixel.y + LIFT);
            float top = free(left - MARGIN, left + width + MARGIN, wanted);
            visible = top - wanted <= MAX_LINES * LINE;
            if (visible) {
                taken.add(new float[] {left - MARGIN, top, left + width + MARGIN});
                label.place.setLocalTranslation(left, top, -2);
            }
        }
        label.place.setCullHint(visible ? CullHint.Never : CullHint.Always);
    }

    /** Returns the lowest free height at or above the wanted one. */
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
        return bottom;
    }
}
