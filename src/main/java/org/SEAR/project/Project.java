package org.SEAR.project;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.files.Assets;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.terrain.Ground;

/** A SEARproject folder that was read whole and found valid. Immutable: nobody changes its objects afterwards. */
public final class Project {
    private final Path folder;
    private final List<SearObject> environment;
    private final List<SEARrobot> robots;
    private final List<String> warnings;
    private final Assets assets;

    private final TerrainGround terrain;

    /** @param terrain null if it has none */
    Project(Path folder, List<SearObject> environment, List<SEARrobot> robots, List<String> warnings, ParsedObject terrain) {
        this.folder = folder;
        this.environment = List.copyOf(environment);
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
     * Reads and validates a folder as it would be with some of its files changed.
     *
     * @param changes bytes by absolute path; null for a file that is to be deleted
     * @throws ProjectException with every problem found
     */
    public static Project read(Path folder, Map<Path, byte[]> changes) throws ProjectException {
        return ProjectSwap.undisturbed(() -> new ProjectReader(folder, changes).read());
    }

    /** The folder of this program: {@code SEARproject} in the working folder, or what the system property {@code sear.project} says. */
    public static Path presentFolder() {
        return ProjectFolder.present();
    }

    /** The SEARproject folder. */
    public Path getFolder() {
        return folder;
    }

    /** All environment objects, ordered by name. */
    public List<SearObject> getEnvironment() {
        return environment;
    }

    /** All robots with their components in place, in the order in which they were made; those that don't know it come first, by name. */
    public List<SEARrobot> getRobots() {
        return robots;
    }

    /** What is legal but probably not meant: a file in {@code robot/} that is no robot's part, a picture that isn't there. */
    public List<String> getWarnings() {
        return warnings;
    }

    /**
     * Loads each model once, and looks at the heads of the elevation maps: {@link #read} only looks whether their files are there.
     *
     * @throws ProjectException with every model that can't be loaded and every map that can't be used
     */
    public void checkFiles() throws ProjectException {
        List<Problem> problems = new ArrayList<>(terrain == null ? List.of() : terrain.brokenMaps());
        Set<String> whole = new HashSet<>();
        for (SearObject object : objects()) {
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

    /** A model of the project that can't be loaded. */
    public Problem problem(Model model, IOException why) {
        String file = (environment.contains(model) ? "environment/" : "robot/") + model.getFileName() + ".xml";
        return new Problem(file, 0, "path", model.getPath(), "a model that can be loaded (" + why.getMessage() + ")");
    }

    /**
     * The ground that the terrain's elevation maps make; loaded when it is asked for first.
     *
     * @return null without a Terrain
     * @throws ProjectException if a map can't be read
     */
    public Ground getGround() throws ProjectException {
        return terrain == null ? null : terrain.get();
    }

    /**
     * Reads the picture that lies over the terrain, as far as {@link #read} has not: a GeoTIFF.
     *
     * @throws ProjectException if it, or a map, can't be read
     */
    public void checkGroundPicture() throws ProjectException {
        if (terrain != null) {
            terrain.checkPicture();
        }
    }

    /**
     * Where on Earth the world's origin lies, as the terrain's map has it.
     *
     * @return null without a Terrain, and for a map without a place on Earth
     * @throws ProjectException if a map can't be read
     */
    public GeoOrigin getOrigin() throws ProjectException {
        return terrain == null ? null : terrain.get().origin;
    }

    /**
     * The part of the terrain's maps that is used, as one GeoTIFF that gives the same ground.
     *
     * @return null without a Terrain, if all of its maps is used, or if their coordinate system has no number by which a file could name it
     * @throws ProjectException if a map can't be read
     */
    public byte[] cutMap() throws ProjectException {
        return terrain == null ? null : terrain.cut();
    }

    /** Pictures and models: the project's own, else those that come with SEAR. */
    public Assets getAssets() {
        return assets;
    }

    /** The triangles of a model or the bytes of a picture live below {@code assets}: the file for a path as written in an object. */
    public Path asset(String path) {
        return folder.resolve("assets").resolve(path).normalize();
    }
}
