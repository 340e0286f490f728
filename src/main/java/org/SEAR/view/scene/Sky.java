// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.asset.AssetManager;
import com.jme3.material.Material;
import com.jme3.material.RenderState.FaceCullMode;
import com.jme3.math.FastMath;
import com.jme3.renderer.queue.RenderQueue.Bucket;
import com.jme3.renderer.queue.RenderQueue.ShadowMode;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.VertexBuffer.Type;
import org.SEAR.camera.Daylight;

/**
 * Background: a sky that darkens upwards, and haze of distant land below a sharp horizon. A sphere around the camera
 * with vertex colours, as cheap as a plain background. The land is only visual: a robot without support falls.
 */
final class Sky {
    private static final float RADIUS = 50;
    private static final int SECTORS = 24;
    private static final float[][] RINGS = Daylight.rings();

    private Sky() {
    }

    static Geometry make(AssetManager assets) {
        Material material = new Material(assets, "Common/MatDefs/Misc/Unshaded.j3md");
        material.setBoolean("VertexColor", true);
        material.getAdditionalRenderState().setDepthWrite(false);
        material.getAdditionalRenderState().setFaceCullMode(FaceCullMode.Off);
        Geometry sky = new Geometry("sky", ball());
        sky.setMaterial(material);
        sky.setQueueBucket(Bucket.Sky);
        sky.setCullHint(CullHint.Never);
        sky.setShadowMode(ShadowMode.Off);
        return sky;
    }

    private static Mesh ball() {
        int corners = RINGS.length * (SECTORS + 1);
        float[] places = new float[3 * corners];
        float[] colors = new float[4 * corners];
        int[] triangles = new int[6 * (RINGS.length - 1) * SECTORS];
        for (int corner = 0; corner < corners; corner++) {
            float[] ring = RINGS[corner / (SECTORS + 1)];
            float around = FastMath.TWO_PI * (corner % (SECTORS + 1)) / SECTORS;
            float up = ring[0] * FastMath.DEG_TO_RAD;
            places[3 * corner] = RADIUS * FastMath.cos(up) * FastMath.sin(around);
            places[3 * corner + 1] = RADIUS * FastMath.sin(up);
            places[3 * corner + 2] = RADIUS * FastMath.cos(up) * FastMath.cos(around);
            System.arraycopy(ring, 1, colors, 4 * corner, 3);
            colors[4 * corner + 3] = 1;
        }
        int next = 0;
        for (int corner = 0; corner < corners - SECTORS - 1; corner++) {
            if (corner % (SECTORS + 1) < SECTORS) {
                int above = corner + SECTORS + 1;
                for (int one : new int[] {corner, corner + 1, above, above, corner + 1, above + 1}) {
                    triangles[next++] = one;
                }
            }
        }
        Mesh mesh = new Mesh();
        mesh.setBuffer(Type.Position, 3, places);
        mesh.setBuffer(Type.Color, 4, colors);
        mesh.setBuffer(Type.Index, 3, triangles);
        mesh.updateBound();
        mesh.setStatic();
        return mesh;
    }
}
