// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.bounding.BoundingSphere;
import com.jme3.math.ColorRGBA;
import com.jme3.math.Transform;
import com.jme3.math.Vector3f;
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
import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.Project;
import org.SEAR.simulator.Snapshot;

/**
 * Physics shapes: outlines of collision shapes, crosses at contact points and the wheels' suspension rays. Window
 * thread only.
 */
public final class DebugShapes {
    private static final ColorRGBA FIXED = new ColorRGBA(0.35f, 0.55f, 1, 1);
    private static final ColorRGBA MOVABLE = new ColorRGBA(0.2f, 1, 0.3f, 1);
    private static final ColorRGBA CONTACT = new ColorRGBA(1, 0.1f, 0.8f, 1);
    private static final ColorRGBA RAY = new ColorRGBA(1, 0.85f, 0.1f, 1);
    /** Half length of a cross's line, metres. */
    private static final float ARM = 0.03f;
    private static final int MAX_LINES = 1024;

    private final WorldView world;
    private final Materials materials;
    private final List<Node> outlines = new ArrayList<>();
    private final List<SEARrobot> robots;
    private final FloatBuffer points = BufferUtils.createFloatBuffer(6 * MAX_LINES);
    private final FloatBuffer colors = BufferUtils.createFloatBuffer(8 * MAX_LINES);
    private final Mesh mesh = new Mesh();
    private final Geometry lines = new Geometry("contacts and wheel rays", mesh);
    private boolean visible = true;
    private int lineCount;

    public DebugShapes(Project project, WorldView world, Materials materials) {
        this.world = world;
        this.materials = materials;
        robots = project.getRobots();
        for (int i = 0; i < project.getEnvironment().size(); i++) {
            SearObject object = project.getEnvironment().get(i);
            outline(world.environment().get(i), object instanceof Shape && ((Shape) object).getMass() > 0
                ? MOVABLE : FIXED);
        }
        for (int i = 0; i < robots.size(); i++) {
            for (SearObject part : robots.get(i).getComponents()) {
                if (!(part instanceof SensorObject) && world.robot(i).getChild(part.getName()) instanceof Node) {
                    outline((Node) world.robot(i).getChild(part.getName()), MOVABLE);
                }
            }
        }
        mesh.setMode(Mesh.Mode.Lines);
        mesh.setBuffer(stream(Type.Position, 3, points));
        mesh.setBuffer(stream(Type.Color, 4, colors));
        lines.setMaterial(materials.lines());
        lines.getMaterial().getAdditionalRenderState().setDepthTest(false);
        lines.setShadowMode(ShadowMode.Off);
        world.root().attachChild(lines);
        setVisible(false);
    }

    private static VertexBuffer stream(Type type, int components, FloatBuffer data) {
        VertexBuffer buffer = new VertexBuffer(type);
        buffer.setupData(Usage.Stream, components, VertexBuffer.Format.Float, data);
        return buffer;
    }

    private void outline(Node node, ColorRGBA color) {
        List<Geometry> solids = node.descendantMatches(Geometry.class);
        Node outline = new Node("outline of " + node.getName());
        for (Geometry solid : solids) {
            Geometry wires = new Geometry("wires", solid.getMesh());
            wires.setMaterial(materials.flat(color));
            wires.getMaterial().getAdditionalRenderState().setWireframe(true);
            wires.setShadowMode(ShadowMode.Off);
            wires.setLocalTransform(relative(solid, node));
            outline.attachChild(wires);
        }
        node.attachChild(outline);
        outlines.add(outline);
    }

    private static Transform relative(Geometry solid, Node node) {
        Transform way = solid.getLocalTransform().clone();
        for (Node parent = solid.getParent(); parent != node; parent = parent.getParent()) {
            way.combineWithParent(parent.getLocalTransform());
        }
        return way;
    }

    public boolean isVisible() {
        return visible;
    }

    public void setVisible(boolean on) {
        visible = on;
        for (Node outline : outlines) {
            outline.setCullHint(on ? CullHint.Inherit : CullHint.Always);
        }
        lines.setCullHint(on ? CullHint.Never : CullHint.Always);
    }

    /** Returns the number of lines for contacts and wheel rays. */
    public int lineCount() {
        return lineCount;
    }

    public void update(Snapshot snapshot) {
        if (!visible) {
            return;
        }
        points.clear();
        colors.clear();
        lineCount = 0;
        for (double[] contact : snapshot.contacts) {
            Vector3f middle = new Vector3f((float) contact[0], (float) contact[1], (float) contact[2]);
            line(middle.add(-ARM, 0, 0), middle.add(ARM, 0, 0), CONTACT);
            line(middle.add(0, -ARM, 0), middle.add(0, ARM, 0), CONTACT);
            line(middle.add(0, 0, -ARM), middle.add(0, 0, ARM), CONTACT);
        }
        for (int i = 0; i < robots.size(); i++) {
            rays(i);
        }
        points.flip();
        colors.flip();
        lines.setCullHint(lineCount > 0 ? CullHint.Never : CullHint.Always);
        if (lineCount > 0) {
            mesh.getBuffer(Type.Position).updateData(points);
            mesh.getBuffer(Type.Color).updateData(colors);
            mesh.updateCounts();
            mesh.setBound(new BoundingSphere(Float.MAX_VALUE, Vector3f.ZERO));
        }
    }

    /**
     * Draws the rays that search for ground: from one radius above a wheel's mount to the suspension's full travel
     * below.
     */
    private void rays(int robot) {
        float rest = 0;
        for (SearObject part : robots.get(robot).getComponents()) {
            Double length = part instanceof Dynamics ? ((Dynamics) part).getRestLength() : null;
            rest = length == null ? rest : length.floatValue();
        }
        List<Wheel> wheels = robots.get(robot).getWheels();
        for (int i = 0; i < wheels.size(); i++) {
            Wheel wheel = wheels.get(i);
            float radius = (float) (wheel.getRadius() * wheel.getScaleY());
            Vector3f mount = new Vector3f((float) wheel.getX(), (float) wheel.getY(), (float) wheel.getZ());
            Vector3f from = world.robot(robot).localToWorld(mount.add(0, radius, 0), null);
            Vector3f to = world.robot(robot).localToWorld(mount.add(0, -radius - rest, 0), null);
            line(from, to, RAY);
        }
    }

    private void line(Vector3f from, Vector3f to, ColorRGBA color) {
        if (lineCount < MAX_LINES) {
            lineCount++;
            points.put(from.x).put(from.y).put(from.z).put(to.x).put(to.y).put(to.z);
            for (int end = 0; end < 2; end++) {
                colors.put(color.r).put(color.g).put(color.b).put(color.a);
            }
        }
    }
}
