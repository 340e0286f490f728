// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.hud;

import com.jme3.font.BitmapFont;
import com.jme3.font.BitmapText;
import com.jme3.math.ColorRGBA;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.shape.Quad;
import org.SEAR.view.scene.Materials;

/**
 * Lines of text on a dark translucent background; text after a tab is in a second column. Hidden while empty. Window
 * thread only.
 */
final class TextPanel {
    private static final ColorRGBA GROUND = new ColorRGBA(0.05f, 0.07f, 0.10f, 0.62f);
    private static final float MARGIN = 8;
    private static final String FROM_TAB = "\t[^\n]*";
    private static final String UP_TO_TAB = "(?m)^[^\t\n]*\t?";
    private final BitmapText text;
    private final BitmapText second;
    private final Geometry ground;
    private final Node node = new Node("panel");
    private String shown = "";

    TextPanel(BitmapFont font, Materials materials, ColorRGBA color, float size) {
        text = text(font, color, size);
        second = text(font, color, size);
        second.setText("");
        ground = new Geometry("ground", new Quad(1, 1));
        ground.setMaterial(materials.flat(GROUND));
        node.attachChild(ground);
        node.attachChild(text);
        node.attachChild(second);
        node.setCullHint(CullHint.Always);
    }

    private static BitmapText text(BitmapFont font, ColorRGBA color, float size) {
        BitmapText text = new BitmapText(font);
        text.setSize(size);
        text.setColor(color);
        return text;
    }

    Node node() {
        return node;
    }

    String text() {
        return shown;
    }

    void setText(String newText) {
        if (!newText.equals(shown)) {
            shown = newText;
            text.setText(newText.replaceAll(FROM_TAB, ""));
            second.setText(newText.indexOf('\t') < 0 ? "" : newText.replaceAll(UP_TO_TAB, ""));
            node.setCullHint(newText.isEmpty() ? CullHint.Always : CullHint.Never);
            ground.setLocalScale(width(), height(), 1);
            ground.setLocalTranslation(0, -height(), -1);
            text.setLocalTranslation(MARGIN, -MARGIN, 0);
            second.setLocalTranslation(text.getLineWidth() + 3 * MARGIN, -MARGIN, 0);
        }
    }

    /** Returns the width, pixels. */
    float width() {
        float columns = second.getText().isEmpty() ? 0 : second.getLineWidth() + 2 * MARGIN;
        return text.getLineWidth() + columns + 2 * MARGIN;
    }

    /** Returns the height, pixels. */
    float height() {
        return text.getHeight() + 2 * MARGIN;
    }

    /** Places the upper left corner, pixels from the window's lower left corner. */
    void place(float left, float top) {
        node.setLocalTranslation(Math.round(left), Math.round(top), 0);
    }
}
