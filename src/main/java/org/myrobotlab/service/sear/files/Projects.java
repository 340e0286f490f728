// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.SEAR.files.AtomicFile;
import org.SEAR.files.LongWork;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.ScriptText;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectOrigin;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.PercentProgress;
import org.SEAR.project.bundle.Progress;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.script.ProjectScript;
import org.SEAR.project.urdf.UrdfImport;
import org.myrobotlab.serial.PortArrivals;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.run.SimulationControl;

/** The project folder and the templates in the jar. Any thread. */
public final class Projects {
    private static final List<String> TEMPLATES = Arrays.asList("controller.py", "userCode.py", "arduino.py");
    private static final String DEFAULT_FOLDER = "SEARproject";
    private static final String ENDING = ".sear";

    private final SimulationControl control;
    private final Host host;
    private final ProjectShelf shelf = new ProjectShelf();

    /** @param host takes the progress of saving and loading; its resources may contain examples */
    public Projects(SimulationControl control, Host host) {
        this.control = control;
        this.host = host;
    }

    /**
     * Returns the paths of the example bundles, sorted by name: from {@code examples} in the working folder, else from
     * MyRobotLab's resources of SEAR, else from the jar. SEAR's own examples are therefore available in every folder.
     */
    public List<String> examples() throws IOException {
        Map<String, String> found = new TreeMap<>();
        for (Path folder : Arrays.asList(Paths.get("examples"), Paths.get(host.getResourceRoot(), "SEAR"))) {
            if (Files.isDirectory(folder)) {
                try (DirectoryStream<Path> bundles = Files.newDirectoryStream(folder, "*.sear")) {
                    bundles.forEach(bundle -> found.putIfAbsent(bundle.getFileName().toString(), bundle.toString()));
                }
            }
        }
        ExampleBundles.paths().forEach(path -> found.putIfAbsent(path.substring(path.lastIndexOf('/') + 1), path));
        return new ArrayList<>(found.values());
    }

    /**
     * Returns {@code SEARproject} in the working folder, or the system property {@code sear.project}, like the objects.
     */
    public static Path folder() {
        return Paths.get(System.getProperty("sear.project", DEFAULT_FOLDER)).toAbsolutePath().normalize();
    }

    /**
     * Moves the current project to a backup.
     *
     * @return its new folder; null if there was no project
     */
    public synchronized Path restart() throws IOException {
        control.refuseWhileAnyRuns("newProject");
        PortArrivals.anotherProject();
        control.scriptSession().anotherProject();
        Path backup = Bundle.newProject(folder(), new PercentProgress("replacing", folder(), host::progress));
        ProjectOrigin.NONE.write(folder());
        report(backup);
        return backup;
    }

    /** Reports a backup with contents, null for none. */
    private void report(Path backup) {
        String words = backup == null ? "" : ProjectShelf.words(backup);
        if (!words.isEmpty()) {
            host.kept(backup, words);
        }
    }

    /** Returns the newest backup; null if there is none. */
    private static Path newest() throws IOException {
        List<Path> backups = ProjectSwap.backups(folder());
        return backups.isEmpty() ? null : backups.get(0);
    }

    /** Returns where the next save of the project writes. */
    public ProjectOrigin origin() {
        try {
            return ProjectOrigin.of(folder());
        } catch (IOException e) {
            return ProjectOrigin.NONE;      // an unreadable file means that the user chooses a name
        }
    }

    /**
     * Returns the projects of the user and the kept ones for a panel, as {@link ProjectShelf#list} describes them.
     */
    public List<Map<String, Object>> list() throws IOException {
        return shelf.list(folder());
    }

    /** Returns the picture of a project from above: {@code {"path": path, "svg": text, empty if there is none}}. */
    public Map<String, Object> picture(String path) throws IOException {
        return shelf.picture(path);
    }

    /**
     * Saves the project as a bundle, which becomes its origin.
     *
     * @param file gets the ending .sear if it has none; its folder must exist
     * @return the absolute path of the bundle
     */
    public synchronized Path save(Path file) throws IOException, ProjectException {
        Path bundle = write(file);
        new ProjectOrigin(withEnding(file.toString()), true).write(folder());
        return bundle;
    }

    /** Writes a copy of the project like {@link #save}. */
    public synchronized Path write(Path file) throws IOException, ProjectException {
        Path bundle = bundle(file);
        Bundle.save(folder(), bundle, new PercentProgress("saving", bundle, host::progress));
        return bundle.toAbsolutePath().normalize();
    }

    /** Saves the project like {@link #save}, but only the used area of the terrain's maps. */
    public synchronized Path saveCut(Path file) throws IOException, ProjectException {
        Path bundle = bundle(file);
        if (!Bundle.saveCut(folder(), bundle, new PercentProgress("saving", bundle, host::progress))) {
            host.progress(bundle + " contains everything: the project has no Terrain with a setArea in a map that "
                + "SEAR can cut");
        }
        return bundle.toAbsolutePath().normalize();
    }

    /** Returns the file to write after checking that it can be written. */
    private static Path bundle(Path file) throws IOException {
        if (!Files.isDirectory(folder())) {
            throw new IOException("there is no project folder " + folder() + ": create some objects first "
                + "(org.SEAR.POJOs)");
        }
        Path bundle = Paths.get(withEnding(file.toString()));
        if (bundle.getFileName().toString().replace(" ", "").equalsIgnoreCase(ENDING)) {
            throw new IOException("the path \"" + file + "\" names no file, legal: the path of a bundle, such as "
                + "\"robot.sear\"");
        }
        Path parent = bundle.toAbsolutePath().normalize().getParent();
        if (parent == null || !Files.isDirectory(parent)) {
            throw new IOException(bundle + " can't be saved: there is no folder " + parent
                + "; create it, or choose another");
        }
        if (!Files.exists(bundle) && !Files.notExists(bundle)) {
            throw new IOException(bundle + " can't be saved: the system can't create such a file; choose a shorter "
                + "name, or another folder");
        }
        return bundle;
    }

    /**
     * Saves the project for a panel, which asks the user before overwriting a file.
     *
     * @param overwrite whether to overwrite an existing file
     * @return {@code {"asked": path, "path": with the ending, "saved": whether it was, "free": an unused path, null if
     *     saved}}
     */
    public synchronized Map<String, Object> saveAs(String path, boolean overwrite)
        throws IOException, ProjectException {
        String named = withEnding(path);
        Path bundle = bundle(ScriptText.path(path));
        boolean saved = overwrite || Files.notExists(bundle);
        if (saved) {
            save(Paths.get(named));
        }
        Map<String, Object> answer = new LinkedHashMap<>();
        answer.put("asked", path);
        answer.put("path", named);
        answer.put("saved", saved);
        answer.put("free", saved ? null : free(named));
        return answer;
    }

    private static String free(String path) {
        String stem = path.substring(0, path.length() - ENDING.length());
        for (int i = 2;; i++) {
            String other = stem + "-" + i + ENDING;
            if (!Files.exists(Paths.get(other))) {
                return other;
            }
        }
    }

    private static String withEnding(String path) {
        return path.toLowerCase(Locale.ROOT).endsWith(ENDING) ? path : path + ENDING;
    }

    /**
     * Replaces the project with a bundle's after reading and checking the whole bundle.
     *
     * @param file may be an example's path without a file
     */
    public synchronized void load(Path file) throws IOException, ProjectException {
        Path ended = Paths.get(withEnding(file.toString()));
        Path meant = !Files.exists(file) && Files.isRegularFile(ended) ? ended : file;
        load(meant, originOf(meant));
    }

    /** Takes a file from a panel: adds a robot in URDF, or replaces the project like {@link #load} with a bundle. */
    public synchronized void receive(Path file) throws IOException, ProjectException {
        if (UrdfImport.isRobot(file)) {
            importUrdf(file, null, false, Map.of());
            return;
        }
        load(file, new ProjectOrigin(file.getFileName().toString(), false));
    }

    private void load(Path file, ProjectOrigin origin) throws IOException, ProjectException {
        control.refuseWhileAnyRuns("loadProject");
        Path before = newest();
        Runnable reported = LongWork.listen(host::progress);
        try {
            ExampleBundles.with(file, bundle -> load(bundle, file));
        } finally {
            reported.run();
        }
        origin.write(folder());
        PortArrivals.anotherProject();
        control.scriptSession().anotherProject();
        control.scriptSession().projectTaken();
        Path after = newest();
        report(after == null || after.equals(before) ? null : after);
    }

    /** Examples and other folders propose a bundle in the working folder; a backup has its project's origin. */
    private static ProjectOrigin originOf(Path file) throws IOException {
        if (file.getFileName() == null) {
            return ProjectOrigin.NONE;
        }
        if (Files.isDirectory(file)) {
            return ProjectOrigin.of(file);
        }
        boolean own = Files.isRegularFile(file) && !ExampleBundles.isOne(file, file);
        return new ProjectOrigin(own ? file.toString() : file.getFileName().toString(), own);
    }

    private Project load(Path bundle, Path meant) throws IOException, ProjectException {
        if (!Files.isRegularFile(bundle) && !Files.isDirectory(bundle)) {
            throw new IOException("there is no file or folder " + bundle.toAbsolutePath() + "; the examples are "
                + String.join(", ", examples()));
        }
        return Bundle.load(bundle, folder(), ExampleBundles.isOne(bundle, meant),
            new PercentProgress("loading", meant, host::progress));
    }

    /**
     * Adds a robot of a bundle or folder to the project.
     *
     * @param robot its name in the bundle; null or empty for the only one
     * @return its name in the project
     */
    public synchronized String importRobot(Path file, String robot) throws IOException, ProjectException {
        control.refuseWhileAnyRuns("importRobot");
        Map<String, String> renamed = ExampleBundles.with(
            file, bundle -> Bundle.importRobot(bundle, folder(), robot, importing(file)));
        report(renamed);
        return renamed.values().iterator().next();
    }

    /**
     * Adds the environment of a bundle or folder to the project.
     *
     * @return the objects' names in the project
     */
    public synchronized List<String> importEnvironment(Path file) throws IOException, ProjectException {
        control.refuseWhileAnyRuns("importEnvironment");
        Map<String, String> renamed = ExampleBundles.with(
            file, bundle -> Bundle.importEnvironment(bundle, folder(), importing(file)));
        report(renamed);
        return new ArrayList<>(renamed.values());
    }

    /**
     * Adds a robot in URDF to the project, as {@link UrdfImport#add} describes.
     *
     * @return its name in the project
     */
    public synchronized String importUrdf(Path file, Pose place, boolean fixed, Map<String, Double> positions)
        throws IOException {
        control.refuseWhileAnyRuns("importUrdf");
        List<String> notes = new ArrayList<>();
        Runnable reported = LongWork.listen(host::progress);
        try {
            String name = UrdfImport.add(file, folder(), place, fixed, positions, notes);
            control.scriptSession().projectTaken();
            notes.forEach(note -> host.progress(file.getFileName() + ": " + note));
            return name;
        } finally {
            reported.run();
        }
    }

    private Progress importing(Path file) {
        return new PercentProgress("importing", file, host::progress);
    }

    private void report(Map<String, String> renamed) {
        control.scriptSession().projectTaken();
        renamed.forEach((old, now) -> {
            if (!old.equals(now)) {
                host.progress("imported \"" + old + "\" as \"" + now + "\", because that name was in use");
            }
        });
    }

    /** Returns the Python script that creates the project's objects. */
    public synchronized String script() throws ProjectException {
        return ProjectScript.of(Project.read(folder()));
    }

    /**
     * Copies a template into a folder.
     *
     * @return the absolute path of the copy
     * @throws IOException if the file exists
     */
    public Path copyTemplate(String name, String folder) throws IOException {
        if (!TEMPLATES.contains(name)) {
            throw new IllegalArgumentException("there is no template \"" + name + "\"; templates: " + TEMPLATES);
        }
        if (folder == null) {
            throw new IllegalArgumentException("the folder is missing (None), legal: the path of a folder, such as "
                + "\"SEARproject\"");
        }
        Path copy = ScriptText.path(folder).resolve(name);
        if (Files.exists(copy)) {
            throw new IOException(copy + " already exists: delete or rename it to get a new copy");
        }
        try (InputStream in = Projects.class.getResourceAsStream("/templates/" + name)) {
            if (in == null) {
                throw new IOException("this sear.jar has no templates/" + name);
            }
            Files.createDirectories(copy.toAbsolutePath().getParent());
            AtomicFile.write(copy, place -> Files.copy(in, place, StandardCopyOption.REPLACE_EXISTING));
        }
        return copy.toAbsolutePath().normalize();
    }
}
