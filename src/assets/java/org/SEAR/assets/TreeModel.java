// SPDX-License-Identifier: Apache-2.0
package org.SEAR.assets;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Tree of 4 m height as OGRE mesh XML: a trunk with four branches, and a crown of seven bumpy balls. The origin is at
 * the foot.
 */
final class TreeModel {
    private static final int SIDES = 12;
    private static final int RINGS = 10;
    private static final double[][] BRANCHES =
        {{0, 0, 0, 0.05, 2.6, 0.02, 0.16, 0.07}, {0, 1.5, 0, 0.75, 2.4, 0.25, 0.06, 0.03},
        {0, 1.7, 0, -0.6, 2.6, 0.4, 0.06, 0.03}, {0, 1.6, 0, -0.2, 2.5, -0.75, 0.06, 0.03},
            {0.02, 2.2, 0.01, 0.2, 3.2, 0.1, 0.06, 0.02}};
    private static final double[][] BALLS = {{0.05, 3.1, 0.05, 0.85}, {0.8, 2.6, 0.3, 0.62}, {-0.65, 2.75, 0.45, 0.6},
        {-0.25, 2.65, -0.8, 0.62},
        {0.5, 2.9, -0.5, 0.6}, {0.1, 2.5, 0.75, 0.55}, {-0.6, 2.5, -0.2, 0.55}};

    private final List<double[]> vertices = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();

    /** Returns the text of Tree.mesh.xml. */
    static String xml() {
        StringBuilder out = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<mesh>\n  <submeshes>\n");
        TreeModel wood = new TreeModel();
        for (double[] b : BRANCHES) {
            wood.branch(b);
        }
        wood.submesh(out, "Tree/Bark");
        TreeModel crown = new TreeModel();
        for (int i = 0; i < BALLS.length; i++) {
            crown.ball(BALLS[i], i);
        }
        crown.submesh(out, "Tree/Leaves");
        return out.append("  </submeshes>\n</mesh>\n").toString();
    }

    /** Returns the text of Tree.material. */
    static String material() {
        return material("Tree/Bark", "bark.png") + material("Tree/Leaves", "leaves.png");
    }

    private static String material(String name, String picture) {
        return "material " + name + "\n{\n  technique\n  {\n    pass\n    {\n      ambient 1 1 1 1\n      diffuse 1 1 "
            + "1 1\n      specular 0 0 0 1 0\n"
            + "      texture_unit\n      {\n        texture " + picture + "\n      }\n    }\n  }\n}\n";
    }

    private void vertex(double x, double y, double z, double nx, double ny, double nz, double u, double v) {
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        vertices.add(new double[] {x, y, z, nx / length, ny / length, nz / length, u, v});
    }

    /** Adds a tapered tube with a cap. The numbers of b: start (0, 1, 2), end (3, 4, 5), radii 6 and 7. */
    private void branch(double[] b) {
        int first = vertices.size();
        for (int end = 0; end < 2; end++) {
            for (int i = 0; i <= SIDES; i++) {
                double angle = 2 * Math.PI * i / SIDES;
                double x = Math.cos(angle);
                double z = Math.sin(angle);
                double radius = b[6 + end];
                vertex(b[3 * end] + radius * x, b[3 * end + 1], b[3 * end + 2] + radius * z, x, 0.1, z,
                    2.0 * i / SIDES, end * 2);
            }
        }
        vertex(b[3], b[4] + b[7], b[5], 0, 1, 0, 0.5, 2.2);
        int top = first + SIDES + 1;
        int tip = vertices.size() - 1;
        for (int i = 0; i < SIDES; i++) {
            faces.add(new int[] {first + i, top + i, first + i + 1});
            faces.add(new int[] {first + i + 1, top + i, top + i + 1});
            faces.add(new int[] {top + i, tip, top + i + 1});
        }
    }

    private void ball(double[] c, int seed) {
        int first = vertices.size();
        for (int ring = 0; ring <= RINGS; ring++) {
            double up = Math.PI * ring / RINGS - Math.PI / 2;
            for (int i = 0; i <= SIDES; i++) {
                double angle = 2 * Math.PI * i / SIDES;
                double x = Math.cos(up) * Math.cos(angle);
                double y = Math.sin(up);
                double z = Math.cos(up) * Math.sin(angle);
                boolean pole = ring == 0 || ring == RINGS;
                double radius = c[3] * (0.88 + 0.24 * Noise.at(pole ? 0 : i % SIDES, ring, 40 + seed));
                vertex(c[0] + radius * x, c[1] + radius * y, c[2] + radius * z, x, y, z, 3.0 * i / SIDES,
                    1.5 * ring / RINGS);
            }
        }
        int row = SIDES + 1;
        for (int ring = 0; ring < RINGS; ring++) {
            for (int i = 0; i < SIDES; i++) {
                int a = first + ring * row + i;
                if (ring > 0) {
                    faces.add(new int[] {a, a + row, a + 1});
                }
                if (ring < RINGS - 1) {
                    faces.add(new int[] {a + 1, a + row, a + row + 1});
                }
            }
        }
    }

    private void submesh(StringBuilder out, String material) {
        out.append("    <submesh material=\"").append(material)
            .append("\" usesharedvertices=\"false\" use32bitindexes=\"false\" operationtype=\"triangle_list\">\n      "
                + "<faces count=\"")
            .append(faces.size()).append("\">\n");
        for (int[] f : faces) {
            out.append(String.format(Locale.ROOT, "        <face v1=\"%d\" v2=\"%d\" v3=\"%d\"/>%n", f[0], f[1], f[2])
                .replace("\r", ""));
        }
        out.append("      </faces>\n      <geometry vertexcount=\"").append(vertices.size())
            .append("\">\n        <vertexbuffer positions=\"true\" normals=\"true\" texture_coords=\"1\" "
                + "texture_coord_dimensions_0=\"2\">\n");
        for (double[] v : vertices) {
            out.append(String.format(Locale.ROOT, "          <vertex><position x=\"%.5f\" y=\"%.5f\" z=\"%.5f\"/>"
                + "<normal x=\"%.4f\" y=\"%.4f\" z=\"%.4f\"/>"
                + "<texcoord u=\"%.4f\" v=\"%.4f\"/></vertex>", v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]))
                .append('\n');
        }
        out.append("        </vertexbuffer>\n      </geometry>\n    </submesh>\n");
    }
}
