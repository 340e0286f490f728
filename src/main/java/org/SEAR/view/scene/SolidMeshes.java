package org.SEAR.view.scene;

import com.jme3.scene.Mesh;
import com.jme3.scene.VertexBuffer.Type;
import com.jme3.util.BufferUtils;
import java.util.Arrays;

/** Meshes of round solids about the y axis, centred in their origin, with the picture wrapped around the side and laid on the caps. */
final class SolidMeshes {
    /** Corners of a circle. */
    static final int SIDES = 32;

    private SolidMeshes() {
    }

    /** @param radius metres, likewise height */
    static Mesh cylinder(float radius, float height) {
        Builder mesh = new Builder();
        mesh.side(radius, radius, height);
        mesh.cap(radius, height / 2, 1);
        mesh.cap(radius, -height / 2, -1);
        return mesh.build();
    }

    /**
     * Apex at +height/2, base at -height/2.
     *
     * @param radius of the base, metres
     */
    static Mesh cone(float radius, float height) {
        Builder mesh = new Builder();
        mesh.side(radius, 0, height);
        mesh.cap(radius, -height / 2, -1);
        return mesh.build();
    }

    private static final class Builder {
        private static final int VERTICES = 4 * (SIDES + 1) + 2;
        private final float[] positions = new float[3 * VERTICES];
        private final float[] normals = new float[3 * VERTICES];
        private final float[] pictures = new float[2 * VERTICES];
        private final int[] indices = new int[12 * SIDES];
        private int vertices;
        private int corners;

        private int vertex(float x, float y, float z, float nx, float ny, float nz, float u, float v) {
            int at = 3 * vertices;
            positions[at] = x;
            positions[at + 1] = y;
            positions[at + 2] = z;
            normals[at] = nx;
            normals[at + 1] = ny;
            normals[at + 2] = nz;
            pictures[2 * vertices] = u;
            pictures[2 * vertices + 1] = v;
            return vertices++;
        }

        private void triangle(int a, int b, int c) {
            indices[corners++] = a;
            indices[corners++] = b;
            indices[corners++] = c;
        }

        /** The picture's left edge is at +z; it runs counter-clockwise seen from above, so that writing on it can be read. */
        void side(float bottom, float top, float height) {
            float slope = bottom - top;
            float length = (float) Math.hypot(height, slope);
            for (int i = 0; i <= SIDES; i++) {
                double angle = 2 * Math.PI * i / SIDES;
                float sin = (float) Math.sin(angle);
                float cos = (float) Math.cos(angle);
                float across = height / length;
                float up = slope / length;
                float u = (float) i / SIDES;
                int low = vertex(bottom * sin, -height / 2, bottom * cos, sin * across, up, cos * across, u, 0);
                int high = vertex(top * sin, height / 2, top * cos, sin * across, up, cos * across, u, 1);
                if (i < SIDES) {
                    triangle(low, low + 2, high);
                    triangle(low + 2, high + 2, high);
                }
            }
        }

        /** @param up +1 for a cap that looks up, -1 for one that looks down */
        void cap(float radius, float y, int up) {
            int middle = vertex(0, y, 0, 0, up, 0, 0.5f, 0.5f);
            for (int i = 0; i <= SIDES; i++) {
                double angle = 2 * Math.PI * i / SIDES;
                float sin = (float) Math.sin(angle);
                float cos = (float) Math.cos(angle);
                int rim = vertex(radius * sin, y, radius * cos, 0, up, 0, 0.5f + sin / 2, 0.5f - cos * up / 2);
                if (i < SIDES) {
                    triangle(middle, up > 0 ? rim : rim + 1, up > 0 ? rim + 1 : rim);
                }
            }
        }

        Mesh build() {
            Mesh mesh = new Mesh();
            mesh.setBuffer(Type.Position, 3, BufferUtils.createFloatBuffer(Arrays.copyOf(positions, 3 * vertices)));
            mesh.setBuffer(Type.Normal, 3, BufferUtils.createFloatBuffer(Arrays.copyOf(normals, 3 * vertices)));
            mesh.setBuffer(Type.TexCoord, 2, BufferUtils.createFloatBuffer(Arrays.copyOf(pictures, 2 * vertices)));
            mesh.setBuffer(Type.Index, 3, BufferUtils.createIntBuffer(Arrays.copyOf(indices, corners)));
            mesh.updateBound();
            mesh.setStatic();
            return mesh;
        }
    }
}
