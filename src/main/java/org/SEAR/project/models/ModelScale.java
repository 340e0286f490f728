// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.SEAR.POJOs.Model;
import org.SEAR.geometry.Triangles;

/** Recognises models whose file was probably drawn in another unit than metres, and names the likely scale. */
final class ModelScale {
    /** Formats without a unit. */
    private static final List<String> WITHOUT_UNIT = List.of(".stl", ".ply", ".obj", ".mesh.xml");
    /** Formats of single parts: larger ones than this, metres, are rare. */
    private static final List<String> OF_PARTS = List.of(".stl", ".ply");
    private static final double LARGEST = 30;
    /** Smaller objects than this, metres, are rare. */
    private static final double SMALLEST = 0.002;
    private static final int THOUSAND = 1000;

    private ModelScale() {
    }

    /** Returns the warning of a model that is likely 1000 times too large or small; null for none. */
    static String warning(Model model, Triangles triangles) {
        String path = model.getPath().toLowerCase(Locale.ROOT);
        double size = size(model, triangles);
        boolean large = size > LARGEST && !model.isTerrain() && OF_PARTS.stream().anyMatch(path::endsWith);
        boolean small = size < SMALLEST && size > 0 && WITHOUT_UNIT.stream().anyMatch(path::endsWith);
        if (!large && !small) {
            return null;
        }
        String scale = Arrays.toString(new double[] {factor(model.getScaleX(), large),
            factor(model.getScaleY(), large), factor(model.getScaleZ(), large)}).replaceAll("[\\[\\]]", "");
        return String.format(Locale.ROOT, "it is %.3g m large. Its file has no unit, and lengths are metres: if it was "
            + "drawn in %s, it is %.3g m, call scale(%s)", size, large ? "millimetres" : "metres and divided by 1000",
            large ? size / THOUSAND : size * THOUSAND, scale);
    }

    private static double factor(double scale, boolean large) {
        return large ? scale / THOUSAND : scale * THOUSAND;
    }

    private static double size(Model model, Triangles triangles) {
        double[] scale = {model.getScaleX(), model.getScaleY(), model.getScaleZ()};
        double size = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < triangles.vertices.length; i += 3) {
                low = Math.min(low, triangles.vertices[i]);
                high = Math.max(high, triangles.vertices[i]);
            }
            size = Math.max(size, (high - low) * Math.abs(scale[axis]));
        }
        return size;
    }
}
