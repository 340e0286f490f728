// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.scene.plugins.blender.BlenderContext;
import com.jme3.scene.plugins.blender.file.BlenderFileException;
import com.jme3.scene.plugins.blender.file.Pointer;
import com.jme3.scene.plugins.blender.file.Structure;
import com.jme3.scene.plugins.blender.modifiers.Modifier;
import com.jme3.scene.plugins.blender.modifiers.ModifierHelper;
import java.util.Collection;
import java.util.Set;
import java.util.function.Consumer;
import org.SEAR.files.FileLimits;
import org.SEAR.files.PrintableText;

/** Reads the modifiers of Blender files: refuses those that make too many faces, and reports unsupported ones. */
final class BlendModifiers extends ModifierHelper {
    /** Faces of a mesh after its modifiers: some seconds of work. */
    static final int MAX_FACES = 250_000;
    /**
     * Faces of all subdivided meshes of a file: some seconds of work. jMonkeyEngine's subdivision needs time in
     * proportion to their square.
     */
    static final int MAX_SUBDIVIDED = 25_000;
    /**
     * Faces times copies of all arrays of a file: some seconds of work. jMonkeyEngine passes all former faces for each
     * copy.
     */
    static final int MAX_COPYING = 30_000_000;
    private static final Set<String> SUPPORTED = Set.of(Modifier.ARRAY_MODIFIER_DATA, Modifier.MIRROR_MODIFIER_DATA,
        Modifier.ARMATURE_MODIFIER_DATA, Modifier.PARTICLE_MODIFIER_DATA, Modifier.SUBSURF_MODIFIER_DATA);
    private static final String NAME = "ModifierData";

    private final String file;
    private final Consumer<String> warnings;
    private double subdivided;
    private double copying;

    BlendModifiers(String version, BlenderContext context, String file, Consumer<String> warnings) {
        super(version, context);
        this.file = file;
        this.warnings = warnings;
    }

    @Override
    public Collection<Modifier> readModifiers(Structure object, BlenderContext context) throws BlenderFileException {
        double faces = faces(object);
        for (Structure modifier : ((Structure) object.getFieldValue("modifiers")).evaluateListBase()) {
            String type = modifier.getType();
            String name = PrintableText.line(type.replace(NAME, "") + " modifier of the object " + object.getName());
            if (!SUPPORTED.contains(type)) {
                warnings.accept("the " + name + " is left out: apply it in Blender, or export .glb");
            }
            double times = times(modifier, type);
            faces *= times;
            if (times > 1) {
                limit("the number of faces after the " + name, faces, MAX_FACES);
            }
            if (times > 1 && type.equals(Modifier.SUBSURF_MODIFIER_DATA)) {
                subdivided += faces;
                limit("the number of faces of subdivided objects, up to the " + name + ',', subdivided, MAX_SUBDIVIDED);
            } else if (times > 1) {
                copying += faces * times;
                limit("the product of faces and copies, up to the " + name + ',', copying, MAX_COPYING);
            }
        }
        return super.readModifiers(object, context);
    }

    private void limit(String what, double faces, int most) throws BlenderFileException {
        if (faces > most) {
            throw new BlenderFileException("modifier", FileLimits.wrong(file, what, Math.round(faces), "at most " + most
                + ": lower its levels or count, apply it in Blender, or export .glb"));
        }
    }

    private static double faces(Structure object) throws BlenderFileException {
        Pointer data = (Pointer) object.getFieldValue("data");
        if (number(object, "type") != 1 || data == null || data.isNull()) {
            return 0;
        }
        Structure mesh = data.fetchData().get(0);
        return Math.max(number(mesh, "totpoly"), number(mesh, "totface"));
    }

    /** Returns a field; 0 if this version of Blender has none. */
    private static double number(Structure of, String field) {
        Object value = of.getFieldValue(field, null);
        return value instanceof Number ? ((Number) value).doubleValue() : 0;
    }

    /** Returns by how much a modifier multiplies the number of faces; an array of a fixed length is unknown. */
    private static double times(Structure modifier, String type) {
        switch (type) {
            case Modifier.SUBSURF_MODIFIER_DATA:
                return Math.pow(4, number(modifier, "levels"));
            case Modifier.ARRAY_MODIFIER_DATA:
                return Math.max(1, number(modifier, "count"));
            case Modifier.MIRROR_MODIFIER_DATA:
                return 2;
            default:
                return 1;
        }
    }
}
