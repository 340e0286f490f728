// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.files.AtomicFile;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectOrigin;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.ProjectException;

/**
 * A project in one file, {@code NAME.sear}: a zip file with {@code sear-version.txt} first, then the files of
 * SEARproject, ordered by name. A failed operation leaves the existing files unchanged. Nothing in a bundle is
 * executed. Any thread; one operation at a time per folder.
 */
public final class Bundle {
    private Bundle() {
    }

    /** Saves without progress messages, see {@link #save(Path, Path, Progress)}. */
    public static void save(Path folder, Path file) throws IOException, ProjectException {
        save(folder, file, Progress.NONE);
    }

    /**
     * Saves a project; the same files give the same bytes. A complete new bundle replaces an existing one. Replacing
     * the project has to wait meanwhile.
     *
     * @throws ProjectException if the project is invalid, or contains files that are not allowed in a bundle (links,
     *     archives, more than 1 GiB)
     * @throws IOException if the file can't be written, or is a link, a pipe or a device
     */
    public static void save(Path folder, Path file, Progress progress) throws IOException, ProjectException {
        ProjectSwap.hold();
        try {
            save(Project.read(folder), file, progress, Map.of());
        } finally {
            ProjectSwap.letGo();
        }
    }

    /**
     * Saves a project like {@link #save(Path, Path, Progress)}, with only the used area of the terrain's maps, in one
     * map. The project stays unchanged.
     *
     * @return whether the map was cut: the project has a Terrain with an area, and the maps' coordinate system has a
     *     code
     */
    public static boolean saveCut(Path folder, Path file, Progress progress) throws IOException, ProjectException {
        Path temporary = Files.createTempDirectory("sear-cut");
        ProjectSwap.hold();
        try {
            Project project = Project.read(folder);
            Map<String, Path> instead = new TerrainCut(project, temporary).make();
            save(project, file, progress, instead);
            return !instead.isEmpty();
        } finally {
            ProjectSwap.letGo();
            ProjectSwap.delete(temporary);
        }
    }

    private static void save(Project read, Path file, Progress progress, Map<String, Path> instead)
        throws IOException, ProjectException {
        Path project = read.getFolder();
        Path target = file.toAbsolutePath().normalize();
        if (target.startsWith(project)) {
            throw new IOException(target + " lies inside the project to save; choose a place outside of " + project);
        }
        if (Files.isDirectory(target)) {
            throw new IOException(target + " is a folder; choose the name of a file, such as "
                + target.resolve("project.sear"));
        }
        if (Files.exists(target, LinkOption.NOFOLLOW_LINKS)
            && !Files.isRegularFile(target, LinkOption.NOFOLLOW_LINKS)) {
            throw new IOException(target + " is a link, a pipe or a device; choose the name of an ordinary file");
        }
        Files.createDirectories(target.getParent());
        AtomicFile.write(target, new BundleWriter(project, target.getFileName().toString(), progress)
            .with(instead)::write);
    }

    /** Loads without progress messages, see {@link #load(Path, Path, Progress)}. */
    public static Project load(Path file, Path folder) throws IOException, ProjectException {
        return load(file, folder, Progress.NONE);
    }

    /**
     * Replaces the project in a folder by a bundle, or by a copy of a folder, after reading and validating it
     * completely. The old project becomes a backup beside it, {@code SEARproject.backup-N}; SEAR keeps the last ten, or
     * fewer large ones.
     *
     * @return the new project
     * @throws ProjectException with all problems of the bundle or its objects; the old project stays
     * @throws IOException if a file can't be read or written; the old project stays
     */
    public static Project load(Path file, Path folder, Progress progress) throws IOException, ProjectException {
        return load(file, folder, false, progress);
    }

    /**
     * Loads as {@link #load(Path, Path, Progress)} does.
     *
     * @param example whether the bundle comes with SEAR: an unchanged example needs no backup
     */
    public static Project load(Path file, Path folder, boolean example, Progress progress)
        throws IOException, ProjectException {
        Path project = folder.toAbsolutePath().normalize();
        try (ProjectSwap swap = ProjectSwap.lock(project)) {
            Path staging = swap.staging();
            unpack(file.toAbsolutePath().normalize(), staging, progress);
            Project.read(staging).checkFiles();
            swap.putInPlace(progress::said);
            if (example) {
                swap.keepAsExample();
            }
            return Project.read(project);
        }
    }

    /** Unpacks a bundle. A project folder, or the folder that contains it, is first saved as a temporary bundle. */
    private static void unpack(Path source, Path folder, Progress progress) throws IOException, ProjectException {
        if (!Files.isDirectory(source)) {
            new BundleReader(source, progress).unpack(folder);
            return;
        }
        Path inside = source.resolve("SEARproject");
        Path packed = Files.createTempFile("sear", ".sear");
        try {
            Path named = source.getFileName() == null ? source : source.getFileName();
            new BundleWriter(Project.read(Files.isDirectory(inside) ? inside : source).getFolder(), named.toString(),
                Progress.NONE).write(packed);
            new BundleReader(packed, progress).unpack(folder);
        } finally {
            Files.deleteIfExists(packed);
        }
    }

    /**
     * Returns whether a zip file contains a file with an ending, in lower case.
     *
     * @throws ProjectException with the problems of its directory
     */
    public static boolean hasFile(Path zip, String ending) throws IOException, ProjectException {
        return new BundleReader(zip, Progress.NONE).hasFile(ending);
    }

    /**
     * Unpacks a zip file of any content with the limits of bundles.
     *
     * @param folder empty
     * @throws ProjectException with all problems
     */
    public static void unpackFiles(Path zip, Path folder) throws IOException, ProjectException {
        new BundleReader(zip.toAbsolutePath().normalize(), Progress.NONE).unpackFiles(folder);
    }

    /**
     * Adds a robot of a bundle or folder to a project. Names, ports, beams and assets that the project already has get
     * a number.
     *
     * @param robot its name in the bundle; null or empty for the only robot
     * @param progress receives messages about removed backups, and about joints with an object that is not imported
     * @return new names by old names, with those of its joints to the world; the robot's comes first
     * @throws ProjectException with all problems of either project, or of the result; the project stays unchanged
     */
    public static Map<String, String> importRobot(Path file, Path folder, String robot, Progress progress)
        throws IOException, ProjectException {
        return add(file, folder, progress, (source, to) -> to.robot(find(source, robot, file)));
    }

    /**
     * Adds the whole environment of a bundle or folder to a project, see {@link #importRobot}.
     *
     * @return new names by old names
     */
    public static Map<String, String> importEnvironment(Path file, Path folder, Progress progress)
        throws IOException, ProjectException {
        return add(file, folder, progress, (source, to) -> to.environment());
    }

    private static SEARrobot find(Project source, String name, Path file) {
        List<SEARrobot> robots = source.getRobots();
        boolean any = name == null || name.isEmpty();
        return robots.stream().filter(robot -> any && robots.size() == 1 || robot.getName().equals(name)).findFirst()
            .orElseThrow(() -> new IllegalArgumentException("robot is \"" + (any ? "" : name) + "\", legal: a robot of "
                + file + ": "
                + robots.stream().map(SEARrobot::getName).collect(Collectors.toList())));
    }

    /** Selects the objects to import. */
    private interface Choice {
        Map<String, String> of(Project source, Import to) throws IOException;
    }

    private static Map<String, String> add(Path file, Path folder, Progress progress, Choice choice)
        throws IOException, ProjectException {
        Path project = folder.toAbsolutePath().normalize();
        Path unpacked = Files.createTempDirectory("sear-import");
        try (ProjectSwap swap = ProjectSwap.lock(project)) {
            unpack(file.toAbsolutePath().normalize(), unpacked, Progress.NONE);
            Path staging = swap.staging();
            Project present = null;
            if (Files.isDirectory(project)) {
                unpack(project, staging, Progress.NONE);
                present = Project.read(staging);
            }
            Project source = Project.read(unpacked);
            source.checkFiles();
            Import to = new Import(source, present, staging);
            Map<String, String> renamed = choice.of(source, to);
            Project.read(staging);
            ProjectOrigin origin = ProjectOrigin.of(project);
            to.left().forEach(progress::said);
            swap.putInPlace(progress::said);
            origin.write(project);
            return renamed;
        } finally {
            ProjectSwap.delete(unpacked);
        }
    }

    /** A check of a project that was found valid. */
    public interface Look {
        /**
         * @return warnings, empty if there are none
         * @throws ProjectException with all problems
         */
        List<String> at(Project project) throws ProjectException;
    }

    /** Checks the files only, without progress messages, see {@link #check(Path, Progress, Look)}. */
    public static List<String> check(Path file) throws IOException, ProjectException {
        return check(file, Progress.NONE, Project::getWarnings);
    }

    /**
     * Checks a bundle, and deletes the unpacked files afterwards.
     *
     * @return warnings, empty if there are none
     * @throws ProjectException with all problems
     */
    public static List<String> check(Path file, Progress progress, Look look) throws IOException, ProjectException {
        Path temporary = Files.createTempDirectory("sear-check");
        try {
            new BundleReader(file.toAbsolutePath().normalize(), progress).unpack(temporary);
            return look.at(Project.read(temporary));
        } finally {
            ProjectSwap.delete(temporary);
        }
    }

    /**
     * Removes the current project, which becomes a backup beside the folder.
     *
     * @param progress receives messages about removed backups
     * @return the backup; null if there was no project
     */
    public static Path newProject(Path folder, Progress progress) throws IOException {
        try (ProjectSwap swap = ProjectSwap.lock(folder.toAbsolutePath().normalize())) {
            return swap.retire(progress::said);
        }
    }
}
