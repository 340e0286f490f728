// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.POJOs.FloorPlan;
import org.SEAR.POJOs.Gravity;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.files.Assets;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.project.models.FloorPlans;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.terrain.Ground;

/** A SEARproject folder that was read completely and found valid. Immutable, and so are its objects. */
public final class Project {
    private final Path folder;
    private final List<SearObject> environment;
    private final List<Joint> joints;
    private final List<SEARrobot> robots;
    private final List<String> warnings;
    private final Assets assets;

    private final TerrainGround terrain;

    /** @param terrain null if there is none */
    Project(Path folder, List<SearObject> environment, List<Joint> joints, List<SEARrobot> robots,
        List<String> warnings, ParsedObject terrain) {
        this.folder = folder;
        this.environment = List.copyOf(environment);
        this.joints = List.copyOf(joints);
        this.robots = List.copyOf(robots);
        this.warnings = List.copyOf(warnings);
        this.assets = new Assets(folder.resolve(ProjectFolder.ASSETS));
        this.terrain = terrain == null ? null : new TerrainGround(terrain, assets);
    }

    /**
     * Reads and validates a folder. Waits while this program replaces it or writes to it.
     *
     * @throws ProjectException with every problem found
     */
    public static Project read(Path folder) throws ProjectException {
        return read(folder, Map.of());
    }

    /**
     * Reads and validates a folder as if some of its files were changed.
     *
     * @param changes bytes by absolute path; null for a deleted file
     * @throws ProjectException with every problem found
     */
    public static Project read(Path folder, Map<Path, byte[]> changes) throws ProjectException {
        return ProjectSwap.undisturbed(() -> new ProjectReader(folder, changes).read());
    }

    /**
     * Returns the program's folder: {@code SEARproject} in the working folder, or the system property
     * {@code sear.project}.
     */
    public static Path presentFolder() {
        return ProjectFolder.present();
    }

    public Path getFolder() {
        return folder;
    }

    /** Returns the joints of the environment, ordered by name. */
    public List<Joint> getJoints() {
        return joints;
    }

    /** Returns the joints of the environment, and those within robots. */
    public List<Joint> getAllJoints() {
        List<Joint> all = new ArrayList<>(joints);
        robots.forEach(robot -> robot.getComponents().stream().filter(Joint.class::isInstance)
            .forEach(part -> all.add((Joint) part)));
        return all;
    }

    /** Returns all environment objects but joints, ordered by name. */
    public List<SearObject> getEnvironment() {
        return environment;
    }

    /** Returns gravity at the start, m/s^2 downwards: that of the project's Gravity, or of the Earth. */
    public double getGravity() {
        return environment.stream().filter(Gravity.class::isInstance).map(Gravity.class::cast).findFirst()
            .map(Gravity::getAcceleration).orElse(Gravity.EARTH);
    }

    /**
     * Returns all robots with their components, in the order of creation; robots without an order come first, by name.
     */
    public List<SEARrobot> getRobots() {
        return robots;
    }

    /**
     * Returns warnings about legal but probably unintended data: a file in {@code robot/} that is not part of a robot,
     * a missing picture.
     */
    public List<String> getWarnings() {
        return warnings;
    }

    /**
     * Loads each model once, loads floor plans and checks the headers of the elevation maps; {@link #read} only checks
     * that these files exist.
     *
     * @throws ProjectException with every unreadable model and floor plan and every unusable map
     */
    public void checkFiles() throws ProjectException {
        List<Problem> problems = new ArrayList<>(terrain == null ? List.of() : terrain.brokenMaps());
        Set<String> whole = new HashSet<>();
        for (SearObject object : objects()) {
            if (object instanceof FloorPlan) {
                try {
                    FloorPlans.of((FloorPlan) object, assets);
                } catch (IOException e) {
                    problems.add(problem((Shape) object, e));
                }
            }
            if (object instanceof Model && !whole.contains(((Model) object).getPath())) {
                try {
                    ModelLoader.withoutPictures(assets, unheard -> { }).triangles((Model) object);
                    whole.add(((Model) object).getPath());
                } catch (IOException e) {
                    problems.add(problem((Model) object, e));
                }
            }
        }
        if (!problems.isEmpty()) {
            throw new ProjectException(problems);
        }
    }

    private List<SearObject> objects() {
        List<SearObject> all = new ArrayList<>(environment);
        robots.forEach(robot -> all.addAll(robot.getComponents()));
        return all;
    }

    /** Returns the problem of a model or of walls that can't be loaded. */
    public Problem problem(Shape shape, IOException why) {
        String file = (environment.contains(shape) ? "environment/" : "robot/") + shape.getFileName() + ".xml";
        if (shape instanceof Model) {
            return new Problem(file, 0, "path", ((Model) shape).getPath(), "a model that can be loaded ("
                + why.getMessage() + ")");
        }
        return new Problem(file, 0, shape instanceof FloorPlan ? "path" : "line", shape instanceof FloorPlan
            ? ((FloorPlan) shape).getPath() : "", "walls that can be drawn (" + why.getMessage() + ")");
    }

    /**
     * Returns the ground of the terrain's elevation maps, loaded on first use.
     *
     * @return null without a Terrain
     * @throws ProjectException if a map can't be read
     */
    public Ground getGround() throws ProjectException {
        return terrain == null ? null : terrain.get();
    }

    /**
     * Reads the terrain's picture if it is a GeoTIFF, which {@link #read} does not read.
     *
     * @throws ProjectException if the picture or a map can't be read
     */
    public void checkGroundPicture() throws ProjectException {
        if (terrain != null) {
            terrain.checkPicture();
        }
    }

    /**
     * Returns the geographic position of the world's origin according to the terrain's map.
     *
     * @return null without a Terrain, and for a map without georeference
     * @throws ProjectException if a map can't be read
     */
    public GeoOrigin getOrigin() throws ProjectException {
        return terrain == null ? null : terrain.get().origin;
    }

    /**
     * Returns the used part of the terrain's maps as one GeoTIFF with the same ground.
     *
     * @return null without a Terrain, if its maps are used completely, or if their coordinate system has no code for a
     *     GeoTIFF
     * @throws ProjectException if a map can't be read
     */
    public byte[] cutMap() throws ProjectException {
        return terrain == null ? null : terrain.cut();
    }

    /** Returns the pictures and models: the project's own, and those that come with SEAR. */
    public Assets getAssets() {
        return assets;
    }

    /** Returns the file of an asset path as written in an object. */
    public Path asset(String path) {
        return folder.resolve("assets").resolve(path).normalize();
    }
}
