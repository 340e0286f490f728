// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.terrain;

import com.jme3.asset.AssetManager;
import com.jme3.material.Material;
import com.jme3.math.Vector4f;
import com.jme3.texture.Image;
import com.jme3.texture.Texture;
import com.jme3.texture.Texture2D;
import com.jme3.texture.image.ColorSpace;
import com.jme3.util.BufferUtils;
import java.nio.ByteBuffer;
import org.SEAR.geometry.HeightField;
import org.SEAR.terrain.relief.GroundGrain;
import org.SEAR.terrain.relief.GroundPicture;

/** Materials of the ground: one picture over the whole area, grain nearby, haze in the distance. Window thread only. */
public final class GroundMaterial {
    /** Distance at which the grain has faded out, metres. */
    static final float GRAINY = GroundGrain.FAR;
    /** Distance at which haze covers two thirds, metres: on a clear day, and the minimum for small worlds. */
    private static final float CLEAR = 38_000;
    private static final float NEAREST_HAZE = 2500;

    /** For ground near enough to receive shadows. */
    final Material shadowed;
    /** For near ground. */
    final Material near;
    /** For ground further than {@link #GRAINY}. */
    final Material far;

    /** @param fine whether textures use slower filters, as in {@code Materials} */
    public GroundMaterial(AssetManager assets, HeightField field, GroundPicture picture, boolean fine) {
        double extentX = (field.rows - 1) * field.spacingX;
        double extentZ = (field.columns - 1) * field.spacingZ;
        far = new Material(assets, "org/SEAR/view/terrain/Ground.j3md");
        far.setTexture("Picture", texture(image(picture), fine, Texture.WrapMode.EdgeClamp));
        far.setVector4("Area", new Vector4f((float) field.lowX, (float) field.lowZ, (float) (1 / extentX),
            (float) (1 / extentZ)));
        far.setFloat("Clear", Math.max(NEAREST_HAZE, Math.min(CLEAR, 2.2f * (float) Math.hypot(extentX, extentZ))));
        near = far.clone();
        near.setTexture("Grain", texture(grain(), fine, Texture.WrapMode.Repeat));
        shadowed = near.clone();
        shadowed.setBoolean("Shadowed", true);
    }

    private static Texture texture(Image image, boolean fine, Texture.WrapMode wrap) {
        Texture2D texture = new Texture2D(image);
        texture.setMagFilter(Texture.MagFilter.Bilinear);
        texture.setMinFilter(fine ? Texture.MinFilter.Trilinear : Texture.MinFilter.BilinearNoMipMaps);
        texture.setAnisotropicFilter(fine ? 8 : 0);
        texture.setWrap(wrap);
        return texture;
    }

    private static Image image(GroundPicture picture) {
        ByteBuffer bytes = BufferUtils.createByteBuffer(4 * picture.pixels.length);
        for (int rgb : picture.pixels) {
            bytes.put((byte) (rgb >> 16)).put((byte) (rgb >> 8)).put((byte) rgb).put((byte) 255);
        }
        bytes.flip();
        return new Image(Image.Format.RGBA8, picture.width, picture.height, bytes, ColorSpace.Linear);
    }

    private static Image grain() {
        ByteBuffer bytes = BufferUtils.createByteBuffer(4 * GroundGrain.SIDE * GroundGrain.SIDE);
        for (byte grey : GroundGrain.grey()) {
            bytes.put(grey).put(grey).put(grey).put((byte) 255);
        }
        bytes.flip();
        return new Image(Image.Format.RGBA8, GroundGrain.SIDE, GroundGrain.SIDE, bytes, ColorSpace.Linear);
    }
}
