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
import java.io.IOException;
import java.nio.FloatBuffer;
import java.util.Map;
import java.util.function.Consumer;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.models.ModelLoader;

/** Makes what is seen of the objects of the grammar. Each node's own pose is left to whoever places it. Window thread only. */
public final class SceneBuilder {
    private static final ColorRGBA TYRE = new ColorRGBA(0.13f, 0.13f, 0.14f, 1);
    private static final ColorRGBA HUB = new ColorRGBA(0.75f, 0.76f, 0.78f, 1);
    private static final ColorRGBA SENSOR = new ColorRGBA(0.16f, 0.18f, 0.22f, 1);
    private static final float FLOOR_THICKNESS = (float) Floor.THICKNESS;
    private static final float SENSOR_SIZE = 0.015f;
    private static final float SPOKE = 0.18f;
    private static final float HALF = 0.5f;
    /** The pictures of surfaces that come with SEAR, and how many metres wide and high one is. */
    private static final Map<String, Float> TILES = Map.of("textures/tiles.png", 1f, "textures/brick.png", 1f, "textures/grass.png", 2f);

    private final ModelLoader models;
    private final Materials materials;
    private final Consumer<String> warnings;

    public SceneBuilder(ModelLoader models, Materials materials, Consumer<String> warnings) {
        this.models = models;
        this.materials = materials;
        this.warnings = warnings;
    }

    /** An object of the environment or a part of a robot; an empty node for what has no shape. */
    Node object(SearObject object) {
        Node node = new Node(object.getName());
        if (object instanceof Wheel) {
            node.attachChild(wheel((Wheel) object));
        } else if (object instanceof Model) {
            node.attachChild(model((Model) object));
        } else if (object instanceof Shape) {
            node.attachChild(solid((Shape) object));
        } else if (object instanceof SensorObject) {
            node.attachChild(sensor(object));
        }
        return node;
    }

    /** A robot: its parts in their places; wheels are separate, because they move. */
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

    private Spatial solid(Shape shape) {
        Geometry solid = new Geometry(shape.getName(), mesh(shape));
        solid.setMaterial(materials.picture(shape.getPicture()));
        solid.setLocalScale(scale(shape));
        solid.setShadowMode(shape instanceof Floor ? ShadowMode.Receive : ShadowMode.CastAndReceive);
        if (shape instanceof Floor) {
            solid.setLocalTranslation(0, -FLOOR_THICKNESS / 2, 0);
        }
        return solid;
    }

    private static Mesh mesh(Shape shape) {
        if (shape instanceof org.SEAR.POJOs.Box) {
            org.SEAR.POJOs.Box box = (org.SEAR.POJOs.Box) shape;
            return tiled(shape, new Box((float) box.getLength() / 2, (float) box.getHeight() / 2, (float) box.getWidth() / 2));
        }
        if (shape instanceof Cylinder) {
            return SolidMeshes.cylinder((float) ((Cylinder) shape).getRadius(), (float) ((Cylinder) shape).getHeight());
        }
        if (shape instanceof Cone) {
            return SolidMeshes.cone((float) ((Cone) shape).getRadius(), (float) ((Cone) shape).getHeight());
        }
        if (shape instanceof Floor) {
            Floor floor = (Floor) shape;
            return tiled(shape, new Box((float) floor.getLength() / 2, FLOOR_THICKNESS / 2, (float) floor.getWidth() / 2));
        }
        throw new IllegalArgumentException("no picture for a " + shape.getClass().getSimpleName() + " (" + shape.getName() + ")");
    }

    /** Repeats a picture of a surface in its true size; other pictures cover each face once. */
    private static Mesh tiled(Shape shape, Box box) {
        Float size = TILES.get(shape.getPicture());
        if (size != null) {
            FloatBuffer places = box.getFloatBuffer(Type.Position);
            FloatBuffer normals = box.getFloatBuffer(Type.Normal);
            FloatBuffer pictures = box.getFloatBuffer(Type.TexCoord);
            for (int i = 0; i < box.getVertexCount(); i++) {
                float x = (float) (places.get(3 * i) * shape.getScaleX()) / size;
                float y = (float) (places.get(3 * i + 1) * shape.getScaleY()) / size;
                float z = (float) (places.get(3 * i + 2) * shape.getScaleZ()) / size;
                boolean level = Math.abs(normals.get(3 * i + 1)) > HALF;
                pictures.put(2 * i, Math.abs(normals.get(3 * i)) > HALF ? z : x);
                pictures.put(2 * i + 1, level ? z : y);
            }
        }
        return box;
    }

    private Spatial wheel(Wheel wheel) {
        Node node = new Node(wheel.getName());
        float radius = (float) wheel.getRadius();
        float width = (float) wheel.getWidth();
        Quaternion axle = new Quaternion().fromAngles(0, 0, (float) Math.PI / 2);
        Geometry tyre = new Geometry("tyre", SolidMeshes.cylinder(radius, width));
        tyre.setMaterial(wheel.getImage() == null ? materials.lit(TYRE) : materials.picture(wheel.getPicture()));
        tyre.setLocalRotation(axle);
        Geometry spoke = new Geometry("spoke", new Box(width / 2 + radius * 0.02f, radius * SPOKE, radius * 0.85f));
        spoke.setMaterial(materials.lit(HUB));
        node.attachChild(tyre);
        node.attachChild(spoke);
        node.setLocalScale(scale(wheel));
        node.setShadowMode(ShadowMode.CastAndReceive);
        return node;
    }

    private Spatial sensor(SearObject object) {
        Geometry housing = new Geometry(object.getName(), new Box(SENSOR_SIZE, SENSOR_SIZE, SENSOR_SIZE));
        housing.setMaterial(materials.lit(SENSOR));
        housing.setShadowMode(ShadowMode.Off);
        return housing;
    }

    private Spatial model(Model object) {
        Node scaled = new Node(object.getName());
        try {
            Spatial model = models.spatial(object);
            if (object.getImage() == null) {
                materials.simplify(model);
            } else {
                model.setMaterial(materials.picture(object.getPicture()));
            }
            scaled.attachChild(model);
            scaled.setLocalScale(scale(object));
            scaled.setShadowMode(object.isTerrain() ? ShadowMode.Receive : ShadowMode.CastAndReceive);
        } catch (IOException e) {
            warnings.accept("a model can't be shown: " + e.getMessage());
        }
        return scaled;
    }
}
