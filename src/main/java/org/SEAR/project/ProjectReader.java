// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.Beam;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Gravity;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Walls;
import org.SEAR.POJOs.Wheel;
import org.SEAR.files.Assets;
import org.SEAR.grammar.Parameter;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.xml.ObjectClasses;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.project.xml.Xml;

/** Reads a SEARproject folder: first each file by itself, then the relations between the objects. One use. */
final class ProjectReader {
    private static final int MAX_FILES = 10000;
    /** Number of files that are read in parallel before their problems are collected. */
    private static final int BATCH = 256;

    private final Path folder;
    /** Replacements of files on disk: their bytes, or null for a deleted file. */
    private final Map<Path, byte[]> changes;
    private final ProblemList problems = new ProblemList();
    private final List<String> warnings = new ArrayList<>();
    private final ObjectClasses classes = ObjectClasses.find();

    /** @param changes bytes by absolute path that replace files on disk; null for a deleted file */
    ProjectReader(Path folder, Map<Path, byte[]> changes) {
        this.folder = folder.toAbsolutePath().normalize();
        this.changes = changes;
    }

    Project read() throws ProjectException {
        try {
            ProjectSwap.recover(folder);
        } catch (IOException e) {
            problems.add(folder.toString(), 0, "", "it can't be opened (" + e.getMessage() + ")",
                "a SEARproject folder");
        }
        if (!Files.isDirectory(folder) && changes.isEmpty()) {
            problems.add(folder.toString(), 0, "", "there is no such folder",
                "a SEARproject folder; creating an object makes one");
            problems.throwIfAny();
        }
        warnOfOtherSpelling("environments", ProjectFolder.ENVIRONMENT);
        warnOfOtherSpelling("robots", ProjectFolder.ROBOT);
        Map<String, ParsedObject> environment = readFolder(ProjectFolder.ENVIRONMENT);
        Map<String, ParsedObject> parts = readFolder(ProjectFolder.ROBOT);
        for (Map.Entry<String, ParsedObject> entry : List.copyOf(parts.entrySet())) {
            Object object = entry.getValue().object;
            if (object instanceof SEARrobot && ((SEARrobot) object).getName().equals(entry.getKey())) {
                readOwnFolder((SEARrobot) object, parts);
            }
        }
        linkBeams(parts);
        ProjectLinker linker = new ProjectLinker(environment, parts, problems, warnings);
        linker.link();
        new AssetCheck(new Assets(folder.resolve(ProjectFolder.ASSETS)), problems, warnings).check(linker.all());
        problems.throwIfAny();
        return new Project(folder, linker.environment(), linker.joints(), linker.robots(), warnings, linker.terrain());
    }

    /** Warns about a folder with the alternative spelling; the dissertation has both. */
    private void warnOfOtherSpelling(String other, String right) {
        if (Files.isDirectory(folder.resolve(other))) {
            warnings.add("the folder " + other + "/ of the project is not read: its objects belong into "
                + right + "/");
        }
    }

    private Map<String, ParsedObject> readFolder(String name) {
        Map<String, ParsedObject> objects = new LinkedHashMap<>();
        read(list(folder.resolve(name), name), name, roots(name)).forEach(read -> objects.put(read.stem, read.parsed));
        return objects;
    }

    /** Reads the parts in a robot's own folder that the robot names; other files there are ignored. */
    private void readOwnFolder(SEARrobot robot, Map<String, ParsedObject> parts) {
        String name = ProjectFolder.ROBOT + "/" + robot.getName();
        Set<String> named = new HashSet<>(robot.getComponentNames());
        List<Path> files = new ArrayList<>();
        for (Path file : list(folder.resolve(name), name)) {
            if (named.contains(robot.getName() + "/" + stem(file))) {
                files.add(file);
            } else {
                warnings.add(name + "/" + file.getFileName() + " is not a component of " + robot
                    + " and is left out; <component>"
                    + robot.getName() + "/" + stem(file) + "</component> in the robot's file adds it");
            }
        }
        read(files, name, roots(name)).forEach(read -> parts.put(robot.getName() + "/" + read.stem, read.parsed));
    }

    private List<ReadFile> read(List<Path> files, String name, Map<String, Class<? extends SearObject>> roots) {
        List<ReadFile> all = new ArrayList<>();
        for (int from = 0; from < files.size() && !problems.isFull(); from += BATCH) {
            List<Path> batch = files.subList(from, Math.min(files.size(), from + BATCH));
            batch.parallelStream().map(file -> new ReadFile(file, changes.get(file), name, roots))
                .collect(Collectors.toList()).forEach(read -> {
                problems.addAll(read.problems);
                all.add(read);
                if (!read.parsed.isBroken()) {
                    checkFile(read.parsed, (SearObject) read.parsed.object, read.stem);
                }
            });
        }
        return all;
    }

    private static String stem(Path file) {
        String fileName = file.getFileName().toString();
        return fileName.substring(0, fileName.length() - ProjectFolder.XML.length());
    }

    /** One file and its problems. Created on any thread, because a project may have thousands of files. */
    private static final class ReadFile {
        final String name;
        final String stem;
        final ProblemList problems = new ProblemList();
        final ParsedObject parsed;

        /** @param bytes replacement of the file's content; null to read the file */
        ReadFile(Path file, byte[] bytes, String folder, Map<String, Class<? extends SearObject>> roots) {
            name = folder + "/" + file.getFileName();
            stem = stem(file);
            ParsedObject read = bytes == null ? Xml.read(file, name, roots, problems)
                : Xml.parse(bytes, name, roots, problems);
            parsed = read == null ? ParsedObject.broken(name, 0) : read;
        }
    }

    private void checkFile(ParsedObject parsed, SearObject object, String stem) {
        if (!object.getName().equals(stem)) {
            problems.add(parsed.file, parsed.line("name"), "name", object.getName(),
                "the name of the file without .xml, \"" + stem + "\"");
        }
        Assembly.crossCheck(object, (element, value, legal) ->
            problems.add(parsed.file, parsed.line(element), element.replaceAll("#.*", ""),
                Parameter.format(value), legal));
    }

    /**
     * Returns the classes that a folder may contain: environment has shapes but wheels, joints and gravity; robot all
     * but gravity, floors, walls and terrains; a robot's own folder no robots either.
     */
    private Map<String, Class<? extends SearObject>> roots(String name) {
        Map<String, Class<? extends SearObject>> roots = new TreeMap<>();
        for (Class<? extends SearObject> type : classes.all()) {
            boolean environment = Shape.class.isAssignableFrom(type) && type != Wheel.class
                || Joint.class.isAssignableFrom(type) || type == Gravity.class;
            boolean part = type != Floor.class && type != Terrain.class && !Walls.class.isAssignableFrom(type)
                && type != Gravity.class
                && (name.equals(ProjectFolder.ROBOT) || type != SEARrobot.class);
            if (name.equals(ProjectFolder.ENVIRONMENT) ? environment : part) {
                roots.put(type.getSimpleName(), type);
            }
        }
        return roots;
    }

    private List<Path> list(Path directory, String name) {
        List<Path> files = onDisk(directory, name);
        if (!changes.isEmpty()) {
            TreeSet<Path> changed = new TreeSet<>(files);
            changes.forEach((file, bytes) -> {
                if (bytes == null) {
                    changed.remove(file);
                } else if (directory.equals(file.getParent()) && isObjectFile(file, name)) {
                    changed.add(file);
                }
            });
            files = List.copyOf(changed);
        }
        if (files.size() > MAX_FILES) {
            problems.add(name, 0, "", "it has more than " + MAX_FILES + " files", "at most " + MAX_FILES + " objects");
            return List.of();
        }
        return files;
    }

    private List<Path> onDisk(Path directory, String name) {
        if (!Files.isDirectory(directory)) {
            return List.of();
        }
        try (Stream<Path> all = Files.list(directory)) {
            return all.filter(file -> isObjectFile(file, name)).sorted().limit(MAX_FILES + 1L)
                .collect(Collectors.toList());
        } catch (IOException e) {
            problems.add(name, 0, "", "it can't be read (" + e + ")", "a readable folder");
            return List.of();
        }
    }

    private boolean isObjectFile(Path file, String folderName) {
        String name = file.getFileName().toString();
        boolean xml = name.endsWith(ProjectFolder.XML);
        if (!xml && name.toLowerCase(Locale.ROOT).endsWith(ProjectFolder.XML)) {
            warnings.add(folderName + "/" + name + " is not read: the name of an object's file ends in "
                + ProjectFolder.XML + ", in small letters");
        }
        return xml && !name.startsWith(".") && !isOwnFolder(file, folderName);
    }

    /** Returns whether the path is the folder of a robot whose name ends like a file's. */
    private static boolean isOwnFolder(Path file, String folderName) {
        return folderName.equals(ProjectFolder.ROBOT) && Files.isDirectory(file)
            && Files.isRegularFile(file.resolveSibling(file.getFileName() + ProjectFolder.XML));
    }

    private void linkBeams(Map<String, ParsedObject> parts) {
        BeamLibrary beams = new BeamLibrary(folder);
        Map<String, Beam> own = beams.own(problems);
        for (ParsedObject parsed : parts.values()) {
            if (parsed.object instanceof Distance && ((Distance) parsed.object).getBeam() != null) {
                Distance sensor = (Distance) parsed.object;
                try {
                    Beam beam = own.get(sensor.getBeam());
                    Assembly.link(sensor, beam != null ? beam : beams.get(sensor.getBeam()));
                } catch (IllegalArgumentException e) {
                    problems.add(parsed.file, parsed.line("beam"), "beam", sensor.getBeam(),
                        String.join(", ", beams.names()));
                }
            }
        }
    }
}
