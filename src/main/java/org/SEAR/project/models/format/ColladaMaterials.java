// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.asset.AssetManager;
import com.jme3.asset.TextureKey;
import com.jme3.material.Material;
import com.jme3.math.ColorRGBA;
import com.jme3.texture.Texture;
import java.io.IOException;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.SEAR.files.PrintableText;

/** Materials of a COLLADA file: the diffuse colour or picture of the common profile. One file. */
final class ColladaMaterials {
    private static final List<String> SHADERS = List.of("phong", "blinn", "lambert", "constant");

    private final AssetManager manager;
    private final String folder;
    private final Consumer<String> warnings;
    private final Map<ColladaElement, Material> known = new HashMap<>();
    private final Set<String> unbound = new TreeSet<>();

    /** @param folder of the model, which pictures are relative to */
    ColladaMaterials(AssetManager manager, String folder, Consumer<String> warnings) {
        this.manager = manager;
        this.folder = folder;
        this.warnings = warnings;
    }

    /**
     * Returns the material of a symbol; white if there is none.
     *
     * @param instance an {@code <instance_geometry>} or {@code <instance_controller>}
     * @param symbol null for white
     */
    Material of(ColladaElement instance, String symbol) throws IOException {
        ColladaElement common = instance.child("bind_material", "technique_common");
        if (symbol != null && common != null) {
            for (ColladaElement each : common.all("instance_material")) {
                if (symbol.equals(each.attribute("symbol"))) {
                    ColladaElement material = each.reference("target", "material");
                    if (!known.containsKey(material)) {
                        known.put(material, read(material));
                    }
                    return known.get(material);
                }
            }
        }
        if (symbol != null) {
            unbound.add(PrintableText.line(symbol));
        }
        return SolidMesh.white(manager);
    }

    /** Warns of surfaces without their material. */
    void warn() {
        if (!unbound.isEmpty()) {
            warnings.accept("it binds no material to " + String.join(", ", unbound) + "; these surfaces are white");
        }
    }

    private Material read(ColladaElement material) throws IOException {
        ColladaElement instance = material.child("instance_effect");
        ColladaElement profile = instance == null ? null : instance.reference("url", "effect").child("profile_COMMON");
        Material made = SolidMesh.white(manager);
        for (String shader : SHADERS) {
            ColladaElement found = profile == null ? null : profile.child("technique", shader);
            ColladaElement diffuse = found == null ? null
                : found.child(shader.equals("constant") ? "emission" : "diffuse");
            if (diffuse != null) {
                paint(made, profile, diffuse);
                return made;
            }
        }
        warnings.accept("<material> in line " + material.line + " has no diffuse colour and is white");
        return made;
    }

    private void paint(Material material, ColladaElement profile, ColladaElement diffuse) throws IOException {
        ColladaElement color = diffuse.child("color");
        ColladaElement texture = diffuse.child("texture");
        if (color != null) {
            double[] rgb = color.numbers(color.text().split("\\s+").length == 3 ? 3 : 4);
            ColorRGBA made = new ColorRGBA((float) rgb[0], (float) rgb[1], (float) rgb[2], 1);
            material.setBoolean("UseMaterialColors", true);
            material.setColor("Diffuse", made);
            material.setColor("Ambient", made);
        } else if (texture != null) {
            String path = picture(profile, texture);
            if (path == null) {
                warnings.accept("the picture of <texture> in line " + texture.line + " is missing; its surface is "
                    + "white");
                return;
            }
            Texture picture = manager.loadTexture(new TextureKey(path));
            picture.setWrap(Texture.WrapMode.Repeat);
            material.setTexture("DiffuseMap", picture);
        }
    }

    /** Returns the path of a texture's picture: by its sampler and surface, or the image directly; null if unknown. */
    private String picture(ColladaElement profile, ColladaElement texture) {
        String name = texture.attribute("texture");
        ColladaElement sampler = parameter(profile, name, "sampler2D");
        ColladaElement image = texture.byId(String.valueOf(name));
        if (sampler != null && sampler.child("instance_image") != null) {
            image = texture.byId(String.valueOf(sampler.child("instance_image").attribute("url")).replaceFirst("^#",
                ""));
        } else if (sampler != null && sampler.child("source") != null) {
            ColladaElement surface = parameter(profile, sampler.child("source").text(), "surface");
            ColladaElement from = surface == null ? null : surface.child("init_from");
            image = from == null ? null : texture.byId(from.text());
        }
        ColladaElement from = image == null ? null : image.child("init_from");
        ColladaElement reference = from == null || from.child("ref") == null ? from : from.child("ref");
        return reference == null || reference.text().isEmpty() ? null : path(reference.text());
    }

    private static ColladaElement parameter(ColladaElement profile, String sid, String kind) {
        for (ColladaElement each : profile.all("newparam")) {
            if (sid != null && sid.equals(each.attribute("sid"))) {
                return each.child(kind);
            }
        }
        return null;
    }

    /** Returns the path of a picture; of one at a full path or URL, the file of its name beside the model. */
    private String path(String uri) {
        String name = uri.replace('\\', '/');
        try {
            name = URLDecoder.decode(name.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException e) {
            name = uri.replace('\\', '/');      // has a percent sign of its own
        }
        boolean absolute = name.startsWith("/") || name.contains(":");
        return folder + (absolute ? name.substring(Math.max(name.lastIndexOf('/'), name.lastIndexOf(':')) + 1) : name);
    }
}
