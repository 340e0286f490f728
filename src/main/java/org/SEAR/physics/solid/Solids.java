// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.io.IOException;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Chessboard;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.FloorPlan;
import org.SEAR.POJOs.Marker;
import org.SEAR.POJOs.Maze;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.Picture;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wall;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.project.Project;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.project.problems.ProjectException;

/**
 * The only list of shapes: each class of the grammar and how to make its solid. It also makes their XML files readable.
 * To add a shape, write its class, its {@link Solid}, its ray and collision shapes, and add a line here.
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
        add(Wall.class, (wall, sources) -> WallLineSolid.of(wall));
        add(Maze.class, (maze, sources) -> WallsSolid.of(maze));
        add(FloorPlan.class, (plan, sources) -> WallsSolid.of(plan, sources.models().getAssets()));
        add(Model.class, (model, sources) -> MeshSolid.of(model, sources.models()));
        add(Wheel.class, (wheel, sources) -> RoundSolid.of(wheel));
    }

    /** Sources for a solid besides the parameters of its shape; only some shapes use them. */
    public interface Sources {
        /** Loader of model files; without models SEAR works without jMonkeyEngine. */
        ModelLoader models();

        /**
         * Elevation of the project's terrain; null if terrains have no solid.
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
     * Returns the geometry of an object; null for an object without geometry (a sensor).
     * @param warnings takes each reason why a model is shown incompletely, once
     * @throws ProjectException with all models and maps of the project that can't be loaded, if this is or needs one
     */
    public static Solid of(SearObject object, Project project, List<String> warnings) throws ProjectException {
        if (!(object instanceof Shape)) {
            return null;
        }
        try {
            return of((Shape) object, sourcesOf(project, warnings));
        } catch (IOException e) {
            project.checkFiles();
            throw new ProjectException(Collections.singletonList(project.problem((Shape) object, e)));
        } catch (ProjectException e) {
            project.checkFiles();
            throw e;
        }
    }

    private static Sources sourcesOf(Project project, List<String> warnings) {
        return new Sources() {
            @Override
            public ModelLoader models() {
                return ModelLoader.withoutPictures(project.getAssets(), text -> {
                    if (!warnings.contains(text)) {
                        warnings.add(text);
                    }
                });
            }

            @Override
            public HeightGrid ground() throws ProjectException {
                return project.getGround().heights;
            }
        };
    }

    /**
     * Returns the geometry of a shape; null for a shape outside the list, and for a terrain without ground.
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

    /** Returns the drawn mesh in the solid's frame; null for a terrain. Boxes repeat a picture of fixed size. */
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
