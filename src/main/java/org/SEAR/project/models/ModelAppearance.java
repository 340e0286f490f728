// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.asset.AssetLoadException;
import com.jme3.material.MatParam;
import com.jme3.material.Material;
import com.jme3.math.ColorRGBA;
import com.jme3.math.Quaternion;
import com.jme3.math.Vector3f;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.VertexBuffer;
import com.jme3.texture.Image;
import com.jme3.texture.Texture;
import com.jme3.texture.image.ImageRaster;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Appearance of a model's triangles, in the order of {@link ModelLoader#triangles}: normals and texture coordinates of
 * the vertices, and the material of each triangle. Immutable, any thread.
 */
public final class ModelAppearance {
    private static final int FULL = 255;
    private static final String[] COLORS = {"Diffuse", "BaseColor", "Color"};
    private static final String[] MAPS = {"DiffuseMap", "BaseColorMap", "ColorMap"};

    /** x, y and z of each vertex's normal. */
    public final float[] normals;
    /** Texture coordinates u and v of each vertex. */
    public final float[] places;
    /** Red, green and blue of each vertex, 0 to 1, which multiply its material; null if no material uses them. */
    public final float[] colors;
    /** Index of each triangle's material. */
    public final short[] materialOf;
    /** All materials. */
    public final List<Surface> materials;

    /** A material: a picture, or a colour alone. Immutable, any thread. */
    public static final class Surface {
        /** Pixels per row; 0 without a picture. */
        public final int width;
        /** Rows. */
        public final int height;
        /** 0xRRGGBB of each pixel from the top left, or the colour alone. */
        public final int[] pixels;

        private Surface(int width, int height, int[] pixels) {
            this.width = width;
            this.height = height;
            this.pixels = pixels;
        }
    }

    private ModelAppearance(float[] normals, float[] places, float[] colors, short[] materialOf,
        List<Surface> materials) {
        this.normals = normals;
        this.places = places;
        this.colors = colors;
        this.materialOf = materialOf;
        this.materials = List.copyOf(materials);
    }

    /** @param solids the geometries of the triangles, in their order */
    static ModelAppearance of(List<Geometry> solids) {
        int vertices = solids.stream().mapToInt(solid -> solid.getMesh().getVertexCount()).sum();
        int triangles = solids.stream().mapToInt(solid -> solid.getMesh().getTriangleCount()).sum();
        float[] normals = new float[3 * vertices];
        float[] places = new float[2 * vertices];
        float[] colors = solids.stream().anyMatch(ModelAppearance::isColored) ? new float[3 * vertices] : null;
        short[] materialOf = new short[triangles];
        List<Surface> materials = new ArrayList<>();
        Map<Material, Short> known = new HashMap<>();
        int vertex = 0;
        int triangle = 0;
        for (Geometry solid : solids) {
            Mesh mesh = solid.getMesh();
            for (int i = 0; i < mesh.getVertexCount(); i++) {
                normal(solid, mesh.getBuffer(VertexBuffer.Type.Normal), i, normals, 3 * (vertex + i));
                place(mesh.getBuffer(VertexBuffer.Type.TexCoord), i, places, 2 * (vertex + i));
            }
            if (colors != null) {
                color(isColored(solid) ? mesh.getBuffer(VertexBuffer.Type.Color) : null, mesh.getVertexCount(), colors,
                    3 * vertex);
            }
            short material = known.computeIfAbsent(solid.getMaterial(), each -> {
                materials.add(surface(each));
                return (short) (materials.size() - 1);
            });
            java.util.Arrays.fill(materialOf, triangle, triangle + mesh.getTriangleCount(), material);
            vertex += mesh.getVertexCount();
            triangle += mesh.getTriangleCount();
        }
        return new ModelAppearance(normals, places, colors, materialOf, materials);
    }

    private static boolean isColored(Geometry solid) {
        return solid.getMaterial() != null && isOn(solid.getMaterial(), "UseVertexColor")
            && solid.getMesh().getBuffer(VertexBuffer.Type.Color) != null;
    }

    /** Adds the colours of a mesh's vertices; white without colours. */
    private static void color(VertexBuffer buffer, int count, float[] colors, int at) {
        for (int i = 0; i < 3 * count; i++) {
            colors[at + i] = buffer == null ? 1 : Math.max(0, Math.min(1, number(buffer, i / 3, i % 3)));
        }
    }

    private static void normal(Geometry solid, VertexBuffer buffer, int vertex, float[] normals, int at) {
        if (buffer == null || vertex >= buffer.getNumElements() || buffer.getNumComponents() < 3) {
            return;
        }
        Vector3f scale = solid.getWorldScale();
        Quaternion turn = solid.getWorldRotation();
        Vector3f normal = new Vector3f(number(buffer, vertex, 0) / scale.x, number(buffer, vertex, 1) / scale.y,
            number(buffer, vertex, 2) / scale.z);
        turn.multLocal(normal).normalizeLocal();
        normals[at] = normal.x;
        normals[at + 1] = normal.y;
        normals[at + 2] = normal.z;
    }

    private static void place(VertexBuffer buffer, int vertex, float[] places, int at) {
        if (buffer != null && vertex < buffer.getNumElements() && buffer.getNumComponents() >= 2) {
            places[at] = number(buffer, vertex, 0);
            places[at + 1] = number(buffer, vertex, 1);
        }
    }

    private static float number(VertexBuffer buffer, int vertex, int component) {
        float value = ((Number) buffer.getElementComponent(vertex, component)).floatValue();
        return Float.isFinite(value) ? value : 0;
    }

    private static Surface surface(Material material) {
        ColorRGBA color = ColorRGBA.White;
        Image picture = null;
        boolean colored = material != null && (!material.getMaterialDef().getAssetName().endsWith("Lighting.j3md")
            || material.getMaterialDef().getAssetName().endsWith("PBRLighting.j3md")
                || isOn(material, "UseMaterialColors"));
        for (int i = 0; material != null && i < COLORS.length; i++) {
            MatParam own = material.getParam(COLORS[i]);
            if (colored && own != null && own.getValue() instanceof ColorRGBA) {
                color = (ColorRGBA) own.getValue();
            }
            MatParam map = material.getParam(MAPS[i]);
            if (map != null && map.getValue() instanceof Texture) {
                picture = ((Texture) map.getValue()).getImage();
            }
        }
        Surface surface = picture == null ? null : pixels(picture, color);
        return surface == null ? new Surface(0, 0, new int[] {rgb(color.r, color.g, color.b)}) : surface;
    }

    private static boolean isOn(Material material, String name) {
        MatParam param = material.getParam(name);
        return param != null && Boolean.TRUE.equals(param.getValue());
    }

    /** Returns null for a picture whose pixels can't be read, such as a compressed one. */
    private static Surface pixels(Image image, ColorRGBA color) {
        try {
            ImageRaster raster = ImageRaster.create(image);
            int width = image.getWidth();
            int height = image.getHeight();
            int[] pixels = new int[width * height];
            ColorRGBA pixel = new ColorRGBA();
            for (int i = 0; i < pixels.length; i++) {
                raster.getPixel(i % width, height - 1 - i / width, pixel);
                pixels[i] = rgb(pixel.r * color.r, pixel.g * color.g, pixel.b * color.b);
            }
            return new Surface(width, height, pixels);
        } catch (UnsupportedOperationException | IllegalArgumentException | AssetLoadException e) {
            return null;
        }
    }

    private static int rgb(float red, float green, float blue) {
        return channel(red) << 16 | channel(green) << 8 | channel(blue);
    }

    private static int channel(float value) {
        return Math.round(FULL * Math.max(0, Math.min(1, value)));
    }
}
