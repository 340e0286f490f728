package org.SEAR.physics.solid;

import java.io.IOException;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.Project;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;

/**
 * The one list of shapes: each class of the grammar and how its solid is made. It also makes their XML files readable. To add a shape, write its
 * class, its {@link Solid}, what of it beams meet and what of it collides, and add a line here.
 */
public final class Solids implements ObjectTypes {
    private static final Map<Class<? extends SearObject>, Maker<Shape>> ALL = new LinkedHashMap<>();

    static {
        add(Box.class, (box, models) -> BoxSolid.of(box));
        add(Cylinder.class, (cylinder, models) -> RoundSolid.of(cylinder));
        add(Cone.class, (cone, models) -> RoundSolid.of(cone));
        add(Sphere.class, (sphere, models) -> EllipsoidSolid.of(sphere));
        add(Terrain.class, (terrain, models) -> null);
        add(Floor.class, (floor, models) -> BoxSolid.of(floor));
        add(Model.class, MeshSolid::of);
        add(Wheel.class, (wheel, models) -> RoundSolid.of(wheel));
    }

    /** Makes the solid of an object. */
    private interface Maker<S extends Shape> {
        Solid make(S shape, Supplier<ModelLoader> models) throws IOException;
    }

    private static <S extends Shape> void add(Class<S> type, Maker<S> maker) {
        ALL.put(type, (shape, models) -> maker.make(type.cast(shape), models));
    }

    @Override
    public Collection<Class<? extends SearObject>> types() {
        return Collections.unmodifiableSet(ALL.keySet());
    }

    /**
     * The geometry of an object; null for an object without (a sensor).
     *
     * @throws ProjectException if a model or the terrain's map can't be loaded
     */
    public static Solid of(SearObject object, Project project) throws ProjectException {
        if (!(object instanceof Shape)) {
            return null;
        }
        if (object instanceof Terrain) {
            return withSurface(new TerrainSolid(project.getGround().field), (Shape) object);
        }
        try {
            return of((Shape) object, () -> ModelLoader.withoutPictures(project.getAssets()));
        } catch (IOException e) {
            String file = (project.getEnvironment().contains(object) ? "environment/" : "robot/") + object.getFileName() + ".xml";
            throw new ProjectException(Collections.singletonList(new Problem(file, 0, "path", ((Model) object).getPath(),
                "a model that can be loaded (" + e.getMessage() + ")")));
        }
    }

    /**
     * The geometry of a shape; null for one that is not in the list, and for a terrain, whose ground the project has.
     *
     * @param models asked for a model only: without one SEAR works without jMonkeyEngine
     * @throws IOException if a model can't be loaded
     */
    public static Solid of(Shape shape, Supplier<ModelLoader> models) throws IOException {
        for (Class<?> type = shape.getClass(); type != null; type = type.getSuperclass()) {
            if (ALL.containsKey(type)) {
                return withSurface(ALL.get(type).make(shape, models), shape);
            }
        }
        return null;
    }

    private static Solid withSurface(Solid solid, Shape shape) {
        if (solid != null) {
            solid.setSurface(Surface.of(shape));
        }
        return solid;
    }
}
