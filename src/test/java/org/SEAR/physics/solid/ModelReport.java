// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.Model;
import org.SEAR.files.Assets;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;
import org.SEAR.project.models.ModelLoader;
import org.myrobotlab.embedded.Json;

/**
 * Prints the number of triangles, bounding box, area, volume, centre and inertia of each model below a folder, or the
 * reason why it can't be loaded. {@code src/test/trimesh/compare.py} compares the lines with trimesh.
 */
public final class ModelReport {
    private ModelReport() {
    }

    /** @param arguments the folder */
    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of(arguments[0]);
        List<Path> files;
        try (Stream<Path> all = Files.walk(folder)) {
            files = all.filter(file -> ModelLoader.isModel(file.toString())).sorted().collect(Collectors.toList());
        }
        for (Path file : files) {
            System.out.println(line(file.getParent(), file.getFileName().toString(),
                folder.relativize(file).toString()));
        }
    }

    private static String line(Path folder, String name, String shown) {
        List<Object> values = new ArrayList<>(List.of(shown));
        try {
            Triangles triangles = ModelLoader.withoutPictures(new Assets(folder), values::add)
                .triangles(new Model("m", name));
            MeshSolid solid = new MeshSolid(triangles, new double[] {1, 1, 1}, Pose.IDENTITY);
            MassProperties mass = solid.perKilogram();
            values.add(List.of(triangles.size(), box(triangles), area(triangles), solid.volume(), mass.centre(),
                mass.inertia.toRows()));
        } catch (IOException e) {
            values.add(e.getMessage());
        }
        return Json.write(values);
    }

    private static double[] box(Triangles of) {
        double[] box = new double[6];
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
        for (int corner : of.indices) {
            for (int axis = 0; axis < 3; axis++) {
                box[axis] = Math.min(box[axis], of.vertices[3 * corner + axis]);
                box[3 + axis] = Math.max(box[3 + axis], of.vertices[3 * corner + axis]);
            }
        }
        return box;
    }

    private static double area(Triangles of) {
        double area = 0;
        for (int i = 0; i < of.indices.length; i += 3) {
            double[][] p = new double[3][3];
            for (int k = 0; k < 9; k++) {
                p[k / 3][k % 3] = of.vertices[3 * of.indices[i + k / 3] + k % 3];
            }
            double x = (p[1][1] - p[0][1]) * (p[2][2] - p[0][2]) - (p[1][2] - p[0][2]) * (p[2][1] - p[0][1]);
            double y = (p[1][2] - p[0][2]) * (p[2][0] - p[0][0]) - (p[1][0] - p[0][0]) * (p[2][2] - p[0][2]);
            double z = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
            area += Math.sqrt(x * x + y * y + z * z) / 2;
        }
        return area;
    }
}
