package org.SEAR.view.scene;

import com.jme3.asset.AssetLoadException;
import com.jme3.asset.AssetManager;
import com.jme3.asset.AssetNotFoundException;
import com.jme3.asset.TextureKey;
import com.jme3.material.Material;
import com.jme3.material.RenderState.BlendMode;
import com.jme3.math.ColorRGBA;
import com.jme3.scene.Geometry;
import com.jme3.scene.Spatial;
import com.jme3.texture.Texture.WrapMode;
import com.jme3.texture.Texture;
import java.util.function.Consumer;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Shape;
import org.SEAR.scene.Glow;

/** What surfaces look like. Window thread only. */
public final class Materials {
    /** Samples that a pixel at a flat angle may take. */
    private static final int ANISOTROPY = 8;
    private static final int OPAQUE = 0xff000000;
    private final AssetManager assets;
    private final boolean fine;
    private final Consumer<String> warnings;

    /**
     * @param fine whether pictures get mipmaps and an anisotropic filter, so that they neither flicker far away nor smear at flat angles; software
     *     OpenGL needs three times as long for that
     */
    public Materials(AssetManager assets, boolean fine, Consumer<String> warnings) {
        this.assets = assets;
        this.fine = fine;
        this.warnings = warnings;
    }

    /** Lit, of a shape's picture or else its colour; the colour, with a warning, where the picture can't be read. */
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
                warnings.accept("the picture " + image + " can't be shown (" + e.getMessage() + "); put a readable one into assets");
            }
        }
        return lit(color(shape.getColor()));
    }

    private static ColorRGBA color(String hex) {
        return color(Integer.parseInt(hex.substring(1), 16));
    }

    /** What is seen of a light that shines so brightly, 0 to 1. */
    static ColorRGBA glow(Led led, double brightness) {
        return color(Glow.of(led.getColor(), brightness));
    }

    /** An opaque colour. */
    static ColorRGBA color(int rgb) {
        return new ColorRGBA().fromIntARGB(OPAQUE | rgb);
    }

    /** Lit, of one colour. */
    Material lit(ColorRGBA color) {
        Material material = new Material(assets, "org/SEAR/view/scene/Surface.j3md");
        material.setColor("Diffuse", color);
        return material;
    }

    /** Not lit, coloured corner by corner; may be seen through. */
    Material lines() {
        Material material = new Material(assets, "Common/MatDefs/Misc/Unshaded.j3md");
        material.setBoolean("VertexColor", true);
        material.getAdditionalRenderState().setBlendMode(BlendMode.Alpha);
        material.getAdditionalRenderState().setDepthWrite(false);
        return material;
    }

    /** Not lit, of one colour. */
    public Material flat(ColorRGBA color) {
        Material material = new Material(assets, "Common/MatDefs/Misc/Unshaded.j3md");
        material.setColor("Color", color);
        if (color.a < 1) {
            material.getAdditionalRenderState().setBlendMode(BlendMode.Alpha);
        }
        return material;
    }

    /**
     * Replaces physically based materials, which need light probes, and shiny ones by plainly lit ones of the same colour and picture: nothing in the
     * world shines.
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
                    geometry.setMaterial(simplified(own, colored ? color(own, "Diffuse") : ColorRGBA.White, "DiffuseMap"));
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
