package org.SEAR.project;

import java.nio.file.Path;
import java.util.List;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.project.models.Assets;
import org.SEAR.project.problems.ProjectException;

/** A SEARproject folder that was read whole and found valid. Immutable: nobody changes its objects afterwards. */
public final class Project {
    private final Path folder;
    private final List<SearObject> environment;
    private final List<SEARrobot> robots;
    private final List<String> warnings;
    private final Assets assets;

    Project(Path folder, List<SearObject> environment, List<SEARrobot> robots, List<String> warnings) {
        this.folder = folder;
        this.environment = List.copyOf(environment);
        this.robots = List.copyOf(robots);
        this.warnings = List.copyOf(warnings);
        this.assets = new Assets(folder.resolve(ProjectFolder.ASSETS));
    }

    /**
     * Reads and validates a folder.
     *
     * @throws ProjectException with every problem found
     */
    public static Project read(Path folder) throws ProjectException {
        return new ProjectReader(folder).read();
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

    /** Where on Earth the world's origin lies, as the terrain's map has it; null without a terrain, and for a map without a place on Earth. */
    public GeoOrigin getOrigin() throws ProjectException {
        return null;
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
