// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.material.Material;
import com.jme3.math.ColorRGBA;
import com.jme3.renderer.queue.RenderQueue.ShadowMode;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.VertexBuffer.Type;
import com.jme3.util.BufferUtils;
import org.SEAR.scene.ViewCone;

/** Lines around a camera's field of view. Window thread only. */
public final class ConeView {
    private final ViewCone cone;
    private final Node node;

    ConeView(ViewCone cone, Materials materials) {
        this.cone = cone;
        node = new Node("what " + cone.sensor + " sees");
        SceneBuilder.place(node, cone.mount);
        Mesh lines = new Mesh();
        lines.setMode(Mesh.Mode.Lines);
        lines.setBuffer(Type.Position, 3, BufferUtils.createFloatBuffer(points(cone.edge)));
        lines.updateBound();
        Geometry geometry = new Geometry("lines", lines);
        ColorRGBA color = Materials.color(ViewCone.COLOR);
        Material material = materials.flat(color);
        geometry.setMaterial(material);
        geometry.setShadowMode(ShadowMode.Off);
        node.attachChild(geometry);
    }

    /** Returns the lines along the edge and from the camera to its corners. */
    private static float[] points(float[] edge) {
        int count = edge.length / 3;
        float[] points = new float[2 * edge.length + 2 * 3 * ViewCone.CORNERS];
        for (int i = 0; i < count; i++) {
            System.arraycopy(edge, 3 * i, points, 6 * i, 3);
            System.arraycopy(edge, 3 * ((i + 1) % count), points, 6 * i + 3, 3);
        }
        for (int corner = 0; corner < ViewCone.CORNERS; corner++) {
            System.arraycopy(edge, 3 * corner * ViewCone.SIDE, points, 2 * edge.length + 6 * corner + 3, 3);
        }
        return points;
    }

    /** Returns the node, in the robot's frame. */
    public Node node() {
        return node;
    }

    ViewCone cone() {
        return cone;
    }

    public boolean isVisible() {
        return node.getLocalCullHint() != CullHint.Always;
    }

    void setVisible(boolean on) {
        node.setCullHint(on ? CullHint.Inherit : CullHint.Always);
    }
}
