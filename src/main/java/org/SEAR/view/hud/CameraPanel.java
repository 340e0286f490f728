// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.hud;

import com.jme3.font.BitmapFont;
import com.jme3.material.Material;
import com.jme3.math.ColorRGBA;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.shape.Quad;
import com.jme3.texture.Image;
import com.jme3.texture.Texture.MagFilter;
import com.jme3.texture.Texture2D;
import com.jme3.texture.image.ColorSpace;
import com.jme3.util.BufferUtils;
import java.nio.ByteBuffer;
import org.SEAR.view.link.CameraFrame;
import org.SEAR.view.scene.Materials;

/** Picture of a camera with a caption, in a corner of the window. Hidden without a picture. Window thread only. */
public final class CameraPanel {
    private static final float SHARE = 0.3f;
    private static final float TALLEST = 0.42f;
    private static final int CHANNELS = 3;
    /** Size, pixels, up to which a picture is shown without smoothing. */
    private static final int EXACT = 64;

    private final Node node = new Node("camera");
    private final Geometry quad = new Geometry("picture", new Quad(1, 1));
    private final Material material;
    private final TextPanel words;
    private CameraFrame shown;
    private ByteBuffer bytes;
    private Image image;

    CameraPanel(BitmapFont font, Materials materials, Node gui, ColorRGBA ink, float size) {
        material = materials.flat(ColorRGBA.White.clone());
        quad.setMaterial(material);
        words = new TextPanel(font, materials, ink, size);
        node.attachChild(quad);
        node.setCullHint(CullHint.Always);
        gui.attachChild(node);
        gui.attachChild(words.node());
    }

    /** Returns the displayed picture, or null. */
    public CameraFrame shown() {
        return shown;
    }

    /**
     * Shows a picture.
     * @param shot picture, or null
     * @param name camera whose picture is expected, or null
     */
    void show(CameraFrame shot, String name) {
        words.setText(shot != null ? shot.camera + ": " + shot.words : name != null ? name + ": no picture yet" : "");
        if (shot == shown) {
            return;
        }
        shown = shot;
        node.setCullHint(shot == null ? CullHint.Always : CullHint.Never);
        if (shot != null) {
            draw(shot);
        }
    }

    private void draw(CameraFrame shot) {
        boolean another = image == null || image.getWidth() != shot.width || image.getHeight() != shot.height;
        if (another) {
            bytes = BufferUtils.createByteBuffer(CHANNELS * shot.width * shot.height);
        }
        bytes.clear();
        for (int row = shot.height - 1; row >= 0; row--) {      // OpenGL's first row is the lowest
            for (int column = 0; column < shot.width; column++) {
                int rgb = shot.pixel(column, row);
                bytes.put((byte) (rgb >> 16)).put((byte) (rgb >> 8)).put((byte) rgb);
            }
        }
        bytes.flip();
        if (another) {
            image = new Image(Image.Format.RGB8, shot.width, shot.height, bytes, null, ColorSpace.Linear);
            Texture2D texture = new Texture2D(image);
            texture.setMagFilter(Math.max(shot.width, shot.height) <= EXACT ? MagFilter.Nearest : MagFilter.Bilinear);
            material.setTexture("ColorMap", texture);
        } else {
            image.setData(bytes);
        }
    }

    /** Places the panel in the lower right corner of a window of this size, above its lower edge, pixels. */
    void place(int width, int height, float edge, float above) {
        if (shown == null) {
            words.place(width - words.width() - edge, above + words.height());
            return;
        }
        float wide = Math.min(SHARE * width, TALLEST * height * shown.width / shown.height);
        float tall = wide * shown.height / shown.width;
        quad.setLocalScale(wide, tall, 1);
        node.setLocalTranslation(Math.round(width - wide - edge), Math.round(above), 0);
        words.place(width - Math.max(wide, words.width()) - edge, above + tall + words.height());
    }
}
