package org.SEAR.project.bundle;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.ProjectException;

/**
 * A whole project in one file, {@code NAME.sear}: a zip file with {@code sear-version.txt} first, then the files of SEARproject in the order of their
 * names. Whatever goes wrong, what was there before stays as it was. Nothing of a bundle is ever run. Any thread; one at a time for a folder.
 */
public final class Bundle {
    private Bundle() {
    }

    /** As {@link #save(Path, Path, Progress)}, telling nobody. */
    public static void save(Path folder, Path file) throws IOException, ProjectException {
        save(folder, file, Progress.NONE);
    }

    /**
     * Saves a project; the same files give the same bytes. A bundle of that name is replaced when the new one is whole. Who replaces the project
     * meanwhile waits.
     *
     * @throws ProjectException if the project is not valid, or has what no bundle may hold (links, archives, more than 1 GiB)
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
     * Saves a project as {@link #save(Path, Path, Progress)} does, but of the terrain's maps only the area that is used, in one map. The project
     * stays as it is.
     *
     * @return whether there was anything to cut: a Terrain with an area, of maps whose coordinate system has a number
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

    private static void save(Project read, Path file, Progress progress, Map<String, Path> instead) throws IOException, ProjectException {
        Path project = read.getFolder();
        Path target = file.toAbsolutePath().normalize();
        if (target.startsWith(project)) {
            throw new IOException(target + " lies in the project that it is to hold; choose a place outside of " + project);
        }
        if (Files.isDirectory(target)) {
            throw new IOException(target + " is a folder; choose the name of a file, such as " + target.resolve("project.sear"));
        }
        if (Files.exists(target, LinkOption.NOFOLLOW_LINKS) && !Files.isRegularFile(target, LinkOption.NOFOLLOW_LINKS)) {
            throw new IOException(target + " is a link, a pipe or a device; choose the name of an ordinary file");
        }
        Files.createDirectories(target.getParent());
        Path temporary = target.resolveSibling("." + target.getFileName() + ProjectFolder.TEMPORARY);
        try {
            new BundleWriter(project, target.getFileName().toString(), progress).with(instead).write(temporary);
            Files.move(temporary, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(temporary);
        }
    }

    /** As {@link #load(Path, Path, Progress)}, telling nobody. */
    public static Project load(Path file, Path folder) throws IOException, ProjectException {
        return load(file, folder, Progress.NONE);
    }

    /**
     * Loads a bundle, or a copy of a folder, in the place of the project in a folder, once it has been read whole and found valid. The
     * old project becomes a backup beside it
     * ({@code SEARproject.backup-N}; the last ten are kept, and less where they are large).
     *
     * @return the new project
     * @throws ProjectException with everything that is wrong with the bundle or its objects; the old project stays
     * @throws IOException if it can't be read or written; the old project stays
     */
    public static Project load(Path file, Path folder, Progress progress) throws IOException, ProjectException {
        return load(file, folder, false, progress);
    }

    /**
     * The same.
     *
     * @param example whether the bundle comes with SEAR: while nobody changes the project, it needs no backup
     */
    public static Project load(Path file, Path folder, boolean example, Progress progress) throws IOException, ProjectException {
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

    /** Unpacks a bundle; a project folder, or the folder that it lies in, is treated as if it had been saved first. */
    private static void unpack(Path source, Path folder, Progress progress) throws IOException, ProjectException {
        if (!Files.isDirectory(source)) {
            new BundleReader(source, progress).unpack(folder);
            return;
        }
        Path inside = source.resolve("SEARproject");
        Path packed = Files.createTempFile("sear", ".sear");
        try {
            Path named = source.getFileName() == null ? source : source.getFileName();
            new BundleWriter(Project.read(Files.isDirectory(inside) ? inside : source).getFolder(), named.toString(), Progress.NONE).write(packed);
            new BundleReader(packed, progress).unpack(folder);
        } finally {
            Files.deleteIfExists(packed);
        }
    }

    /**
     * Adds a robot of a bundle or folder to a project. Names, ports, beams and assets that are taken there get a number.
     *
     * @param robot its name in the bundle; null or empty if that has one robot only
     * @param progress hears of backups that have gone
     * @return new names by the old ones; the robot's is the first
     * @throws ProjectException with everything that is wrong with either, or would be then; the project stays as it was
     */
    public static Map<String, String> importRobot(Path file, Path folder, String robot, Progress progress) throws IOException, ProjectException {
        return add(file, folder, progress, (source, to) -> to.robot(find(source, robot, file)));
    }

    /**
     * Adds all of the environment of a bundle or folder to a project, as {@link #importRobot} does a robot.
     *
     * @return new names by the old ones
     */
    public static Map<String, String> importEnvironment(Path file, Path folder, Progress progress) throws IOException, ProjectException {
        return add(file, folder, progress, (source, to) -> to.environment());
    }

    private static SEARrobot find(Project source, String name, Path file) {
        List<SEARrobot> robots = source.getRobots();
        boolean any = name == null || name.isEmpty();
        return robots.stream().filter(robot -> any && robots.size() == 1 || robot.getName().equals(name)).findFirst()
            .orElseThrow(() -> new IllegalArgumentException("robot is \"" + (any ? "" : name) + "\", legal: a robot of " + file + ": "
                + robots.stream().map(SEARrobot::getName).collect(Collectors.toList())));
    }

    /** What is taken of another project. */
    private interface Choice {
        Map<String, String> of(Project source, Import to) throws IOException;
    }

    private static Map<String, String> add(Path file, Path folder, Progress progress, Choice choice) throws IOException, ProjectException {
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
            Map<String, String> renamed = choice.of(source, new Import(source, present, staging));
            Project.read(staging);
            swap.putInPlace(progress::said);
            return renamed;
        } finally {
            ProjectSwap.delete(unpacked);
        }
    }

    /** What somebody wants to see of a project that was found valid. */
    public interface Look {
        /**
         * @return warnings, empty if there are none
         * @throws ProjectException with everything that is wrong
         */
        List<String> at(Project project) throws ProjectException;
    }

    /** As {@link #check(Path, Progress, Look)}, of what stands in the files only, telling nobody. */
    public static List<String> check(Path file) throws IOException, ProjectException {
        return check(file, Progress.NONE, Project::getWarnings);
    }

    /**
     * Checks a bundle without keeping anything of it.
     *
     * @return warnings, empty if there are none
     * @throws ProjectException with everything that is wrong
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
     * Starts with no project at all; the present one becomes a backup beside it.
     *
     * @param progress hears of backups that have gone
     * @return the backup; null if there was no project
     */
    public static Path newProject(Path folder, Progress progress) throws IOException {
        try (ProjectSwap swap = ProjectSwap.lock(folder.toAbsolutePath().normalize())) {
            return swap.retire(progress::said);
        }
    }
}
