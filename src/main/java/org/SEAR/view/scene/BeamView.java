// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.bounding.BoundingSphere;
import com.jme3.math.Vector3f;
import com.jme3.renderer.queue.RenderQueue.Bucket;
import com.jme3.renderer.queue.RenderQueue.ShadowMode;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.VertexBuffer.Type;
import com.jme3.scene.VertexBuffer.Usage;
import com.jme3.scene.VertexBuffer;
import com.jme3.util.BufferUtils;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.scene.BeamFan;

/** One sensor's beams as lines, with a sphere at each hit. Window thread only. */
public final class BeamView {
    private static final float OPAQUE = 0.75f;
    private static final float FAINT = 0.28f;
    /** Low-polygon sphere: an octahedron subdivided once. */
    private static final int[] BALL_TRIANGLES = new int[8 * 4 * 3];
    private static final float[] BALL = ball();
    private static final int BALL_CORNERS = BALL.length / 3;

    private final BeamFan fan;
    private final Node node;
    private final FloatBuffer ends;
    private final FloatBuffer colors;
    private final FloatBuffer spheres;
    private final Mesh lines = new Mesh();
    private final Mesh hits = new Mesh();
    private final Geometry hitGeometry;
    private double[] shown;
    private int hitCount;

    BeamView(BeamFan fan, Materials materials) {
        this.fan = fan;
        node = new Node("beams of " + fan.sensor);
        SceneBuilder.place(node, fan.mount);
        ends = BufferUtils.createFloatBuffer(6 * fan.lines.length);
        colors = BufferUtils.createFloatBuffer(8 * fan.lines.length);
        spheres = BufferUtils.createFloatBuffer(3 * BALL_CORNERS * fan.size());
        lines.setMode(Mesh.Mode.Lines);
        lines.setBuffer(stream(Type.Position, 3, ends));
        lines.setBuffer(stream(Type.Color, 4, colors));
        hits.setBuffer(stream(Type.Position, 3, spheres));
        hits.setBuffer(Type.Index, 3, triangles(fan.size()));
        float reach = 0;
        for (float range : fan.ranges) {
            reach = Math.max(reach, range);
        }
        lines.setBound(new BoundingSphere(reach, Vector3f.ZERO));
        hits.setBound(new BoundingSphere(reach, Vector3f.ZERO));
        Geometry rays = new Geometry("lines", lines);
        rays.setMaterial(materials.lines());
        hitGeometry = new Geometry("hits", hits);
        hitGeometry.setMaterial(materials.flat(Materials.color(fan.hitColor)));
        rays.setQueueBucket(Bucket.Transparent);
        node.setShadowMode(ShadowMode.Off);
        node.attachChild(rays);
        node.attachChild(hitGeometry);
    }

    private static VertexBuffer stream(Type type, int components, FloatBuffer data) {
        VertexBuffer buffer = new VertexBuffer(type);
        buffer.setupData(Usage.Stream, components, VertexBuffer.Format.Float, data);
        return buffer;
    }

    Node node() {
        return node;
    }

    BeamFan fan() {
        return fan;
    }

    public boolean isVisible() {
        return node.getLocalCullHint() != CullHint.Always;
    }

    void setVisible(boolean on) {
        node.setCullHint(on ? CullHint.Inherit : CullHint.Always);
    }

    /** Returns the number of beams with a hit. */
    public int hitCount() {
        return hitCount;
    }

    /**
     * Draws a reading.
     * @param lengths metres, infinite without a hit; null for no reading, which draws beams in full length
     */
    void update(double[] lengths) {
        if (lengths == shown && shown != null) {
            return;
        }
        shown = lengths == null ? new double[0] : lengths;
        ends.clear();
        colors.clear();
        spheres.clear();
        hitCount = 0;
        for (int i = 0; i < fan.size(); i++) {
            if (isHit(i)) {
                sphere(i, (float) shown[i]);
            }
        }
        for (int beam : fan.lines) {
            line(beam);
        }
        spheres.flip();
        ends.flip();
        colors.flip();
        lines.getBuffer(Type.Position).updateData(ends);
        lines.getBuffer(Type.Color).updateData(colors);
        hitGeometry.setCullHint(hitCount > 0 ? CullHint.Inherit : CullHint.Always);
        if (hitCount > 0) {
            hits.getBuffer(Type.Position).updateData(spheres);
            IntBuffer seen = (IntBuffer) hits.getBuffer(Type.Index).getData();
            seen.limit(hitCount * BALL_TRIANGLES.length);
            hits.getBuffer(Type.Index).updateData(seen);
            hits.updateCounts();
        }
        lines.updateCounts();
    }

    private boolean isHit(int beam) {
        return beam < shown.length && shown[beam] <= fan.ranges[beam];
    }

    private void line(int beam) {
        boolean hit = isHit(beam);
        float length = fan.cut && hit ? (float) shown[beam] : fan.ranges[beam];
        ends.put(0).put(0).put(0);
        ends.put(fan.directions[3 * beam] * length).put(fan.directions[3 * beam + 1] * length)
            .put(fan.directions[3 * beam + 2] * length);
        float alpha = hit || !fan.cut ? OPAQUE : FAINT;
        for (int end = 0; end < 2; end++) {
            colors.put(fan.colors[3 * beam]).put(fan.colors[3 * beam + 1]).put(fan.colors[3 * beam + 2]).put(alpha);
        }
    }

    private void sphere(int beam, float length) {
        hitCount++;
        for (int i = 0; i < BALL.length; i++) {
            spheres.put(fan.directions[3 * beam + i % 3] * length + BALL[i] * fan.hitRadius);
        }
    }

    /** Returns the corners of a unit sphere. */
    private static float[] ball() {
        List<Vector3f> corners = new ArrayList<>();
        int at = 0;
        for (int octant = 0; octant < 8; octant++) {
            Vector3f a = new Vector3f((octant & 1) == 0 ? 1 : -1, 0, 0);
            Vector3f b = new Vector3f(0, (octant & 2) == 0 ? 1 : -1, 0);
            Vector3f c = new Vector3f(0, 0, (octant & 4) == 0 ? 1 : -1);
            boolean mirrored = Integer.bitCount(octant) % 2 == 1;
            at = face(corners, BALL_TRIANGLES, at, mirrored ? new Vector3f[] {a, c, b} : new Vector3f[] {a, b, c});
        }
        float[] ball = new float[3 * corners.size()];
        for (int i = 0; i < ball.length; i++) {
            ball[i] = corners.get(i / 3).get(i % 3);
        }
        return ball;
    }

    /** Adds the four triangles of an octahedron's face. Corners are shared between faces. */
    private static int face(List<Vector3f> corners, int[] triangles, int start, Vector3f[] corner) {
        Vector3f ab = corner[0].add(corner[1]).normalizeLocal();
        Vector3f bc = corner[1].add(corner[2]).normalizeLocal();
        Vector3f ca = corner[2].add(corner[0]).normalizeLocal();
        int at = start;
        for (Vector3f one : new Vector3f[] {corner[0], ab, ca, ab, corner[1], bc, ca, bc, corner[2], ab, bc, ca}) {
            int known = corners.indexOf(one);
            if (known < 0) {
                known = corners.size();
                corners.add(one);
            }
            triangles[at++] = known;
        }
        return at;
    }

    /** Returns the triangles of several spheres, three corners each. */
    private static IntBuffer triangles(int balls) {
        IntBuffer all = BufferUtils.createIntBuffer(balls * BALL_TRIANGLES.length);
        for (int ball = 0; ball < balls; ball++) {
            for (int corner : BALL_TRIANGLES) {
                all.put(ball * BALL_CORNERS + corner);
            }
        }
        all.flip();
        return all;
    }
}
