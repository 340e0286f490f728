// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.asset.AssetInfo;
import com.jme3.scene.Node;
import java.io.IOException;
import java.util.Locale;
import java.util.function.Consumer;
import org.SEAR.files.FileLimits;

/**
 * Reader of COLLADA models (Khronos, "COLLADA - Digital Asset Schema", 1.4.1 and 1.5.0): the scene's nodes with their
 * transforms, in metres, y up. Skinned meshes are in their bind pose; animations have no effect. One use.
 */
public final class ColladaReader {
    private static final AffineMatrix Y_UP = AffineMatrix.IDENTITY;
    private static final AffineMatrix Z_UP = AffineMatrix.ofRows(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0);
    private static final AffineMatrix X_UP = AffineMatrix.ofRows(0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0);

    private final AssetInfo info;
    private final String file;
    private final Consumer<String> warnings;
    private final ColladaElement root;
    private final ColladaGeometry geometry;
    private final ColladaMaterials materials;
    private final Node model;
    private int nodes;
    private long vertices;
    private long triangles;
    private int skins;

    /**
     * @param bytes XML without a document type
     * @param warnings receives each reason why the model is not shown as its file says
     */
    public ColladaReader(AssetInfo info, byte[] bytes, Consumer<String> warnings) throws IOException {
        this.info = info;
        this.file = info.getKey().getName();
        this.warnings = warnings;
        root = ColladaElement.parse(file, bytes);
        geometry = new ColladaGeometry(file, warnings);
        materials = new ColladaMaterials(info.getManager(), info.getKey().getFolder(), warnings);
        model = new Node(file);
    }

    /**
     * Returns the model, a mesh for each material of each node.
     *
     * @throws IOException that names the element, its line, the value and the legal values
     */
    public Node read() throws IOException {
        ColladaElement instance = root.child("scene", "instance_visual_scene");
        ColladaElement scene = instance != null ? instance.reference("url", "visual_scene")
            : root.child("library_visual_scenes", "visual_scene");
        if (scene == null) {
            throw root.wrong("the scene", null, "a <scene> with an <instance_visual_scene>");
        }
        AffineMatrix frame = upAxis().times(scaled(unit()));
        for (ColladaElement node : scene.all("node")) {
            add(node, frame, 1);
        }
        geometry.warn();
        materials.warn();
        if (skins > 0) {
            warnings.accept(skins + " skinned meshes are in their bind pose");
        }
        return model;
    }

    private double unit() throws IOException {
        ColladaElement unit = root.child("asset", "unit");
        String meter = unit == null ? null : unit.attribute("meter");
        try {
            double value = meter == null ? 1 : Double.parseDouble(meter);
            if (value > 0 && value < Double.MAX_VALUE) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw unit.wrong("meter", meter, "a number above 0");
        }
        throw unit.wrong("meter", meter, "a number above 0");
    }

    private AffineMatrix upAxis() throws IOException {
        ColladaElement axis = root.child("asset", "up_axis");
        switch (axis == null ? "Y_UP" : axis.text().toUpperCase(Locale.ROOT)) {
            case "Y_UP":
                return Y_UP;
            case "Z_UP":
                return Z_UP;
            case "X_UP":
                return X_UP;
            default:
                throw axis.wrong("the text", axis.text(), "X_UP, Y_UP or Z_UP");
        }
    }

    private static AffineMatrix scaled(double factor) {
        return AffineMatrix.ofRows(factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, factor, 0);
    }

    private void add(ColladaElement node, AffineMatrix parent, int depth) throws IOException {
        FileLimits.range(file, "the number of nodes, each as often as it is used,", ++nodes, 0,
            ModelLimits.MAX_NODES - 1);
        if (depth > ModelLimits.MAX_DEPTH) {
            throw node.wrong("the nesting", "without end or too deep", "at most " + ModelLimits.MAX_DEPTH + " deep");
        }
        AffineMatrix frame = parent;
        for (ColladaElement each : node.children) {
            switch (each.name) {
                case "instance_geometry":
                    show(each, each.reference("url", "geometry"), frame);
                    break;
                case "instance_controller":
                    skin(each, each.reference("url", "controller"), frame);
                    break;
                case "instance_node":
                    add(each.reference("url", "node"), frame, depth + 1);
                    break;
                case "node":
                    add(each, frame, depth + 1);
                    break;
                default:
                    AffineMatrix own = transform(each);
                    frame = own == null ? frame : frame.times(own);
            }
        }
    }

    /** Returns a transform of a node; null for another element. */
    private static AffineMatrix transform(ColladaElement of) throws IOException {
        switch (of.name) {
            case "matrix":
                return matrix(of);
            case "translate":
                double[] move = of.numbers(3);
                return AffineMatrix.ofRows(1, 0, 0, move[0], 0, 1, 0, move[1], 0, 0, 1, move[2]);
            case "scale":
                double[] scale = of.numbers(3);
                return AffineMatrix.ofRows(scale[0], 0, 0, 0, 0, scale[1], 0, 0, 0, 0, scale[2], 0);
            case "rotate":
                return rotation(of, of.numbers(4));
            case "lookat":
            case "skew":
                throw of.wrong("the transform", of.name, "matrix, translate, rotate or scale");
            default:
                return null;
        }
    }

    private static AffineMatrix matrix(ColladaElement of) throws IOException {
        AffineMatrix matrix = AffineMatrix.ofFourRows(of.numbers(16));
        if (matrix == null) {
            throw of.wrong("the fourth row", of.text(), "0 0 0 1");
        }
        return matrix;
    }

    private static AffineMatrix rotation(ColladaElement of, double[] turn) throws IOException {
        double length = Math.sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
        if (length == 0 && turn[3] != 0) {
            throw of.wrong("the axis", of.text(), "an axis that is not 0");
        }
        double x = length == 0 ? 0 : turn[0] / length;
        double y = length == 0 ? 0 : turn[1] / length;
        double z = length == 0 ? 0 : turn[2] / length;
        double c = Math.cos(Math.toRadians(turn[3]));
        double s = Math.sin(Math.toRadians(turn[3]));
        double d = 1 - c;
        return AffineMatrix.ofRows(c + x * x * d, x * y * d - z * s, x * z * d + y * s, 0,
            x * y * d + z * s, c + y * y * d, y * z * d - x * s, 0,
            x * z * d - y * s, y * z * d + x * s, c + z * z * d, 0);
    }

    private void skin(ColladaElement instance, ColladaElement controller, AffineMatrix frame) throws IOException {
        ColladaElement skin = controller.child("skin");
        if (skin == null) {
            warnings.accept("<controller> in line " + controller.line + " is left out, legal: a <skin>");
            return;
        }
        ColladaElement bind = skin.child("bind_shape_matrix");
        skins++;
        show(instance, skin.reference("source", "geometry"), bind == null ? frame : frame.times(matrix(bind)));
    }

    private void show(ColladaElement instance, ColladaElement of, AffineMatrix frame) throws IOException {
        for (ColladaGeometry.Part part : geometry.parts(of)) {
            FileLimits.range(file, "the number of meshes of all nodes", model.getQuantity(), 0,
                ModelLimits.MAX_NODES - 2);
            vertices += part.mesh.positions.length / 3;
            triangles += part.mesh.indices.length / 3;
            FileLimits.range(file, "the number of vertices of all nodes", vertices, 0, ModelLimits.MAX_TRIANGLES);
            FileLimits.range(file, "the number of triangles of all nodes", triangles, 0, ModelLimits.MAX_TRIANGLES);
            SolidMesh mesh = part.mesh.copy();
            mesh.move(frame);
            model.attachChild(SolidMesh.geometry("geometry in line " + of.line, mesh.mesh(),
                materials.of(instance, part.material)));
        }
    }
}
