// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.asset.AssetLoadException;
import com.jme3.asset.AssetManager;
import com.jme3.asset.AssetNotFoundException;
import com.jme3.asset.TextureKey;
import com.jme3.material.Material;
import com.jme3.material.RenderState.BlendMode;
import com.jme3.math.ColorRGBA;
import com.jme3.renderer.queue.RenderQueue.Bucket;
import com.jme3.scene.Geometry;
import com.jme3.scene.Spatial;
import com.jme3.texture.Texture.WrapMode;
import com.jme3.texture.Texture;
import java.util.function.Consumer;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Shape;
import org.SEAR.scene.Glow;

/** Materials of surfaces. Window thread only. */
public final class Materials {
    /** Maximum number of anisotropic samples per pixel. */
    private static final int ANISOTROPY = 8;
    private static final int OPAQUE = 0xff000000;
    private final AssetManager assets;
    private final boolean fine;
    private final Consumer<String> warnings;

    /**
     * @param fine whether textures get mipmaps and anisotropic filtering, against flicker in the distance and blur at
     *     flat angles. Software OpenGL takes three times as long with them.
     */
    public Materials(AssetManager assets, boolean fine, Consumer<String> warnings) {
        this.assets = assets;
        this.fine = fine;
        this.warnings = warnings;
    }

    /**
     * Returns a lit material with a shape's picture or colour. If the picture can't be read, uses the colour and warns.
     */
    Material surface(Shape shape) {
        String image = shape.getPicture();
        if (image != null) {
            try {
                TextureKey key = new TextureKey(image, true);
                key.setGenerateMips(fine);
                Texture texture = assets.loadTexture(key);
                texture.setAnisotropicFilter(fine ? ANISOTROPY : 0);
                texture.setWrap(WrapMode.Repeat);
                Material material = lit(ColorRGBA.White);
                material.setTexture("DiffuseMap", texture);
                return material;
            } catch (AssetNotFoundException | AssetLoadException e) {
                warnings.accept("SEAR can't show the picture " + image + " (" + e.getMessage()
                    + "); put a readable one into assets");
            }
        }
        return lit(color(shape.getColor()));
    }

    private static ColorRGBA color(String hex) {
        return color(Integer.parseInt(hex.substring(1), 16));
    }

    /** Returns the displayed colour of a light at a brightness, 0 to 1. */
    static ColorRGBA glow(Led led, double brightness) {
        return color(Glow.of(led.getColor(), brightness));
    }

    /** Returns an opaque colour. */
    static ColorRGBA color(int rgb) {
        return new ColorRGBA().fromIntARGB(OPAQUE | rgb);
    }

    /** Returns a lit material of one colour. */
    Material lit(ColorRGBA color) {
        Material material = new Material(assets, "org/SEAR/view/scene/Surface.j3md");
        material.setColor("Diffuse", color);
        return material;
    }

    /** Returns an unlit, translucent material with vertex colours. */
    Material lines() {
        Material material = new Material(assets, "Common/MatDefs/Misc/Unshaded.j3md");
        material.setBoolean("VertexColor", true);
        material.getAdditionalRenderState().setBlendMode(BlendMode.Alpha);
        material.getAdditionalRenderState().setDepthWrite(false);
        return material;
    }

    /** Returns an unlit material of one colour. */
    public Material flat(ColorRGBA color) {
        Material material = new Material(assets, "Common/MatDefs/Misc/Unshaded.j3md");
        material.setColor("Color", color);
        if (color.a < 1) {
            material.getAdditionalRenderState().setBlendMode(BlendMode.Alpha);
        }
        return material;
    }

    /**
     * Replaces physically based materials, which need light probes, and shiny ones by diffuse ones with the same colour
     * and picture.
     */
    void simplify(Spatial model) {
        model.depthFirstTraversal(spatial -> {
            if (spatial instanceof Geometry) {
                Geometry geometry = (Geometry) spatial;
                Material own = geometry.getMaterial();
                if (own.getMaterialDef().getAssetName().endsWith("/PBRLighting.j3md")) {
                    geometry.setMaterial(simplified(own, color(own, "BaseColor"), "BaseColorMap"));
                } else if (own.getMaterialDef().getAssetName().endsWith("/Lighting.j3md")) {
                    boolean colored = Boolean.TRUE.equals(own.getParamValue("UseMaterialColors"));
                    geometry.setMaterial(simplified(own, colored ? color(own, "Diffuse") : ColorRGBA.White,
                        "DiffuseMap"));
                }
                if (own.isTransparent() || own.getAdditionalRenderState().getBlendMode() == BlendMode.Alpha) {
                    geometry.setQueueBucket(Bucket.Transparent);
                }
            }
        });
    }

    private static ColorRGBA color(Material of, String parameter) {
        ColorRGBA color = of.getParamValue(parameter);
        return color == null ? ColorRGBA.White : color;
    }

    private Material simplified(Material own, ColorRGBA color, String picture) {
        Material material = lit(color);
        if (own.getParam(picture) != null) {
            material.setTexture("DiffuseMap", own.getParamValue(picture));
        }
        if (Boolean.TRUE.equals(own.getParamValue("UseVertexColor"))) {
            material.setBoolean("CornerColors", true);
        }
        if (own.getParam("AlphaDiscardThreshold") != null) {
            material.setFloat("Opaque", own.getParamValue("AlphaDiscardThreshold"));
        }
        material.getAdditionalRenderState().set(own.getAdditionalRenderState());
        material.setTransparent(own.isTransparent());
        return material;
    }
}
