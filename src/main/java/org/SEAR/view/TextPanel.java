package org.SEAR.view;

import com.jme3.font.BitmapFont;
import com.jme3.font.BitmapText;
import com.jme3.math.ColorRGBA;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.shape.Quad;

/** Lines of text on a dark translucent ground. Hidden while empty. Window thread only. */
final class TextPanel {
    private static final ColorRGBA GROUND = new ColorRGBA(0.05f, 0.07f, 0.10f, 0.62f);
    private static final float MARGIN = 8;
    private final BitmapText text;
    private final Geometry ground;
    private final Node node = new Node("panel");
    private String shown = "";

    TextPanel(BitmapFont font, Materials materials, ColorRGBA color, float size) {
        text = new BitmapText(font);
        text.setSize(size);
        text.setColor(color);
        ground = new Geometry("ground", new Quad(1, 1));
        ground.setMaterial(materials.flat(GROUND));
        node.attachChild(ground);
        node.attachChild(text);
        node.setCullHint(CullHint.Always);
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
            text.setText(newText);
            node.setCullHint(newText.isEmpty() ? CullHint.Always : CullHint.Never);
            ground.setLocalScale(width(), height(), 1);
            ground.setLocalTranslation(0, -height(), -1);
            text.setLocalTranslation(MARGIN, -MARGIN, 0);
        }
    }

    /** Pixels. */
    float width() {
        return text.getLineWidth() + 2 * MARGIN;
    }

    /** Pixels. */
    float height() {
        return text.getHeight() + 2 * MARGIN;
    }

    /** Puts the panel's left upper corner there, pixels from the window's left lower corner. */
    void place(float left, float top) {
        node.setLocalTranslation(Math.round(left), Math.round(top), 0);
    }
}
