// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.xml.ObjectClasses;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.project.xml.Xml;

/**
 * A project with the changes of an edit: the project's files, and the files that the edit replaces. One use, guarded by
 * the project lock.
 */
final class EditDraft {
    private final ObjectFiles files;
    private final Map<String, byte[]> changes = new LinkedHashMap<>();
    private final Map<String, Class<? extends SearObject>> classes = new TreeMap<>();

    EditDraft(ObjectFiles files) {
        this.files = files;
        ObjectClasses.find().all().forEach(type -> classes.put(type.getSimpleName(), type));
    }

    private byte[] bytes(String path) throws IOException {
        return changes.containsKey(path) ? changes.get(path) : files.read(path);
    }

    boolean has(String path) throws IOException {
        return bytes(path) != null;
    }

    /**
     * Returns a new object with the content of a file.
     *
     * @return null if there is no such file
     * @throws ProjectException if the file has no valid object
     */
    SearObject read(String path) throws IOException, ProjectException {
        byte[] bytes = bytes(path);
        if (bytes == null) {
            return null;
        }
        ProblemList problems = new ProblemList();
        ParsedObject parsed = Xml.parse(bytes, path, classes, problems);
        problems.throwIfAny();
        return (SearObject) parsed.object;
    }

    /** Reads an object as {@link #read} does, but returns null also for an invalid file. */
    SearObject readIfWhole(String path) throws IOException {
        try {
            return read(path);
        } catch (ProjectException e) {
            return null;
        }
    }

    void write(String path, SearObject object) {
        changes.put(path, Xml.write(object).getBytes(StandardCharsets.UTF_8));
    }

    void delete(String path) {
        changes.put(path, null);
    }

    /** Returns the available classes, by the names of their elements. */
    Map<String, Class<? extends SearObject>> classes() {
        return classes;
    }

    /**
     * Returns the paths of the files in {@code environment/} or {@code robot/}, in order, without those in robots' own
     * folders.
     */
    List<String> list(boolean part) throws IOException {
        String folder = part ? ProjectFolder.ROBOT : ProjectFolder.ENVIRONMENT;
        TreeSet<String> paths = new TreeSet<>();
        if (Files.isDirectory(files.file(folder))) {
            try (DirectoryStream<Path> all = Files.newDirectoryStream(files.file(folder), "*" + ProjectFolder.XML)) {
                for (Path file : all) {
                    if (Files.isRegularFile(file) && !file.getFileName().toString().startsWith(".")) {
                        paths.add(folder + "/" + file.getFileName());
                    }
                }
            }
        }
        for (Map.Entry<String, byte[]> change : changes.entrySet()) {
            if (change.getKey().startsWith(folder + "/") && change.getKey().lastIndexOf('/') == folder.length()) {
                if (change.getValue() == null) {
                    paths.remove(change.getKey());
                } else {
                    paths.add(change.getKey());
                }
            }
        }
        return new ArrayList<>(paths);
    }

    /** Returns the replacements of files on disk. */
    Map<Path, byte[]> overlay() {
        Map<Path, byte[]> overlay = new HashMap<>();
        changes.forEach((path, bytes) -> overlay.put(files.file(path), bytes));
        return overlay;
    }

    /** Returns the changes of the edit; empty if it changes nothing. */
    List<FileChange> changes() throws IOException {
        List<FileChange> all = new ArrayList<>();
        for (Map.Entry<String, byte[]> change : changes.entrySet()) {
            byte[] before = files.read(change.getKey());
            if (!Arrays.equals(before, change.getValue())) {
                all.add(new FileChange(change.getKey(), before, change.getValue()));
            }
        }
        return all;
    }
}
