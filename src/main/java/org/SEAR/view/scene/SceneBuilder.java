// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.math.ColorRGBA;
import com.jme3.math.Quaternion;
import com.jme3.math.Vector3f;
import com.jme3.renderer.queue.RenderQueue.ShadowMode;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import com.jme3.scene.VertexBuffer.Type;
import com.jme3.scene.shape.Box;
import com.jme3.scene.shape.Sphere;
import com.jme3.util.BufferUtils;
import java.io.IOException;
import java.util.function.Consumer;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.Solids;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.project.problems.ProjectException;

/** Creates the scene nodes of objects. The caller sets each node's pose. Window thread only. */
public final class SceneBuilder {
    private static final ColorRGBA TYRE = new ColorRGBA(0.13f, 0.13f, 0.14f, 1);
    private static final ColorRGBA HUB = new ColorRGBA(0.75f, 0.76f, 0.78f, 1);
    private static final ColorRGBA SENSOR = new ColorRGBA(0.16f, 0.18f, 0.22f, 1);
    private static final float SENSOR_SIZE = 0.015f;
    private static final float SPOKE = 0.18f;
    private static final int LED_SIDES = 12;

    private final ModelLoader models;
    private final Materials materials;
    private final Consumer<String> warnings;

    public SceneBuilder(ModelLoader models, Materials materials, Consumer<String> warnings) {
        this.models = models;
        this.materials = materials;
        this.warnings = warnings;
    }

    /**
     * Returns the node of an object or a robot's part. The node is empty for objects without a shape and for terrain,
     * which is drawn separately.
     */
    Node object(SearObject object) {
        Node node = new Node(object.getName());
        try {
            if (object instanceof Wheel) {
                node.attachChild(wheel((Wheel) object));
            } else if (object instanceof Model) {
                node.attachChild(model((Model) object));
            } else if (object instanceof Shape && !(object instanceof Terrain)) {
                node.attachChild(solid((Shape) object));
            } else if (object instanceof SensorObject) {
                node.attachChild(sensor(object));
            } else if (object instanceof Led) {
                node.attachChild(led((Led) object));
            }
        } catch (IOException | ProjectException e) {
            warnings.accept("SEAR can't show a model: " + e.getMessage());
        }
        return node;
    }

    /** Returns a robot with its parts, except wheels, which move separately. */
    Node robot(SEARrobot robot) {
        Node node = new Node(robot.getName());
        for (SearObject component : robot.getComponents()) {
            if (!(component instanceof Wheel)) {
                Node part = object(component);
                place(part, ObjectPose.of(component));
                node.attachChild(part);
            }
        }
        return node;
    }

    static void place(Spatial spatial, Pose pose) {
        spatial.setLocalTranslation((float) pose.x, (float) pose.y, (float) pose.z);
        spatial.setLocalRotation(new Quaternion((float) pose.qx, (float) pose.qy, (float) pose.qz, (float) pose.qw));
    }

    private static Vector3f scale(Shape shape) {
        return new Vector3f((float) shape.getScaleX(), (float) shape.getScaleY(), (float) shape.getScaleZ());
    }

    private Spatial solid(Shape shape) throws IOException, ProjectException {
        Solid solid = Solids.of(shape, () -> models);
        if (solid == null) {
            return new Node(shape.getName());
        }
        Geometry geometry = new Geometry(shape.getName(), mesh(Solids.look(solid, shape)));
        geometry.setMaterial(materials.surface(shape));
        geometry.setShadowMode(shape instanceof Floor ? ShadowMode.Receive : ShadowMode.CastAndReceive);
        place(geometry, solid.offset);
        return geometry;
    }

    private static Mesh mesh(SurfaceMesh look) {
        Mesh mesh = new Mesh();
        mesh.setBuffer(Type.Position, 3, BufferUtils.createFloatBuffer(look.getPositions()));
        mesh.setBuffer(Type.Normal, 3, BufferUtils.createFloatBuffer(look.getNormals()));
        mesh.setBuffer(Type.TexCoord, 2, BufferUtils.createFloatBuffer(look.getPictures()));
        mesh.setBuffer(Type.Index, 3, BufferUtils.createIntBuffer(look.getIndices()));
        mesh.updateBound();
        mesh.setStatic();
        return mesh;
    }

    private Spatial wheel(Wheel wheel) throws IOException, ProjectException {
        Node node = new Node(wheel.getName());
        Solid solid = Solids.of(wheel, () -> models);
        Geometry tyre = new Geometry("tyre", mesh(solid.look()));
        tyre.setMaterial(wheel.getImage() == null && !wheel.hasColor() ? materials.lit(TYRE)
            : materials.surface(wheel));
        place(tyre, solid.offset);
        float radius = (float) wheel.getRadius();
        Geometry spoke = new Geometry(
            "spoke", new Box((float) wheel.getWidth() / 2 + radius * 0.02f, radius * SPOKE, radius * 0.85f));
        spoke.setMaterial(materials.lit(HUB));
        spoke.setLocalScale(scale(wheel));
        node.attachChild(tyre);
        node.attachChild(spoke);
        node.setShadowMode(ShadowMode.CastAndReceive);
        return node;
    }

    private Spatial sensor(SearObject object) {
        Geometry housing = new Geometry(object.getName(), new Box(SENSOR_SIZE, SENSOR_SIZE, SENSOR_SIZE));
        housing.setMaterial(materials.lit(SENSOR));
        housing.setShadowMode(ShadowMode.Off);
        return housing;
    }

    private Spatial led(Led led) {
        Geometry bulb = new Geometry(led.getName(), new Sphere(LED_SIDES, LED_SIDES, (float) led.getSize() / 2));
        bulb.setMaterial(materials.flat(Materials.glow(led, 0)));
        bulb.setShadowMode(ShadowMode.Off);
        return bulb;
    }

    private Spatial model(Model object) throws IOException {
        Node scaled = new Node(object.getName());
        Spatial model = models.spatial(object);
        FlatNormals.add(model);
        if (object.getPicture() == null && !object.hasColor()) {
            materials.simplify(model);
        } else {
            model.setMaterial(materials.surface(object));
        }
        scaled.attachChild(model);
        scaled.setLocalScale(scale(object));
        scaled.setShadowMode(object.isTerrain() ? ShadowMode.Receive : ShadowMode.CastAndReceive);
        return scaled;
    }
}
