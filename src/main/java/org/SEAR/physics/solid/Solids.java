package org.SEAR.physics.solid;

import java.io.IOException;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Chessboard;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Marker;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.Picture;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.SurfaceMesh;
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
        add(Box.class, (box, sources) -> BoxSolid.of(box));
        add(Cylinder.class, (cylinder, sources) -> RoundSolid.of(cylinder));
        add(Cone.class, (cone, sources) -> RoundSolid.of(cone));
        add(Sphere.class, (sphere, sources) -> EllipsoidSolid.of(sphere));
        add(Marker.class, (marker, sources) -> BoxSolid.of(marker));
        add(Chessboard.class, (board, sources) -> BoxSolid.of(board));
        add(Picture.class, (picture, sources) -> BoxSolid.of(picture));
        add(Terrain.class, (terrain, sources) -> TerrainSolid.of(sources.ground()));
        add(Floor.class, (floor, sources) -> BoxSolid.of(floor));
        add(Model.class, (model, sources) -> MeshSolid.of(model, sources.models()));
        add(Wheel.class, (wheel, sources) -> RoundSolid.of(wheel));
    }

    /** What a solid is made from beside the parameters of its shape; asked only by the shapes that need it. */
    public interface Sources {
        /** Models by their files; without one SEAR works without jMonkeyEngine. */
        ModelLoader models();

        /**
         * The heights of the project's terrain; null where terrains are to have no solid.
         *
         * @throws ProjectException if the terrain's map can't be loaded
         */
        default HeightGrid ground() throws ProjectException {
            return null;
        }
    }

    /** Makes the solid of an object. */
    private interface Maker<S extends Shape> {
        Solid make(S shape, Sources sources) throws IOException, ProjectException;
    }

    private static <S extends Shape> void add(Class<S> type, Maker<S> maker) {
        ALL.put(type, (shape, sources) -> maker.make(type.cast(shape), sources));
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
        try {
            return of((Shape) object, sourcesOf(project));
        } catch (IOException e) {
            String file = (project.getEnvironment().contains(object) ? "environment/" : "robot/") + object.getFileName() + ".xml";
            throw new ProjectException(Collections.singletonList(new Problem(file, 0, "path", ((Model) object).getPath(),
                "a model that can be loaded (" + e.getMessage() + ")")));
        }
    }

    private static Sources sourcesOf(Project project) {
        return new Sources() {
            @Override
            public ModelLoader models() {
                return ModelLoader.withoutPictures(project.getAssets());
            }

            @Override
            public HeightGrid ground() throws ProjectException {
                return project.getGround().heights;
            }
        };
    }

    /**
     * The geometry of a shape; null for one that is not in the list, and for a terrain without ground.
     *
     * @throws IOException if a model can't be loaded
     * @throws ProjectException if the terrain's map can't be loaded
     */
    public static Solid of(Shape shape, Sources sources) throws IOException, ProjectException {
        for (Class<?> type = shape.getClass(); type != null; type = type.getSuperclass()) {
            if (ALL.containsKey(type)) {
                return withSurface(ALL.get(type).make(shape, sources), shape);
            }
        }
        return null;
    }

    /** What a shape looks like in its solid's frame: a picture that is repeated in its true size is so on boxes; null for a terrain. */
    public static SurfaceMesh look(Solid solid, Shape shape) {
        SurfaceMesh look = solid.look();
        Double tile = shape.getPictureTile();
        if (tile != null && solid instanceof BoxSolid) {
            look.tile(tile);
        }
        return look;
    }

    private static Solid withSurface(Solid solid, Shape shape) {
        if (solid != null) {
            solid.setSurface(Surface.of(shape));
        }
        return solid;
    }
}
