// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.Draft;
import org.SEAR.POJOs.Model;
import org.SEAR.files.Assets;
import org.SEAR.geometry.Triangles;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.models.ModelLoader;

/** Finds the meshes of a URDF, copies them into a project, and reads them. One use, one thread. */
final class UrdfMeshes {
    /** Folders above the URDF's in which packages are searched. */
    private static final int MAX_UP = 4;
    private static final long MAX_TEXT = 64 << 20;
    private static final Set<String> BESIDE = Set.of("mtl", "bin", "png", "jpg", "jpeg", "tga", "bmp", "gif");

    /** A mesh in the project. */
    static final class Mesh {
        /** Below assets. */
        final String path;
        final Triangles triangles;
        /** Whether SEAR reads its z axis as y. */
        final boolean isZUp;

        Mesh(String path, Triangles triangles, boolean isZUp) {
            this.path = path;
            this.triangles = triangles;
            this.isZUp = isZUp;
        }
    }

    private final Path folder;
    private final Path top;
    private final Path project;
    private final String below;
    private final UrdfNotes notes;
    /** Made after the first copy, since it needs the folder of assets. */
    private ModelLoader loader;
    private final Map<Path, Mesh> read = new HashMap<>();
    private final Map<Path, String> folders = new HashMap<>();

    /**
     * @param file of the URDF
     * @param within folder that contains all files that may be read; null for some folders above the URDF's
     * @param name of the robot
     */
    UrdfMeshes(Path file, Path within, Path project, String name, UrdfNotes notes) {
        folder = file.toAbsolutePath().normalize().getParent();
        this.project = project;
        this.notes = notes;
        String free = name;
        for (int i = 2; Files.exists(project.resolve("assets").resolve(free)); i++) {
            free = name + "_" + i;
        }
        below = free;
        Path highest = folder;
        for (int i = 0; i < MAX_UP && highest.getParent() != null && highest.getParent().getParent() != null; i++) {
            highest = highest.getParent();
        }
        top = within == null ? highest : within;
    }

    /** Returns a mesh in the project; null, with a note, if it is missing or unreadable. */
    Mesh mesh(String given, int line) throws IOException {
        Path found = find(given);
        if (found == null || !ModelLoader.isModel(found.toString())) {
            notes.add("mesh " + given + " is left out: " + (found == null
                ? "there is no such file in the URDF's folder or its package"
                : "legal: " + String.join(", ", ModelLoader.ENDINGS) + ModelLoader.CONVERT), line);
            return null;
        }
        if (!read.containsKey(found)) {
            read.put(found, copied(found, given, line));
        }
        return read.get(found);
    }

    private Mesh copied(Path found, String given, int line) throws IOException {
        boolean zUp = found.toString().toLowerCase(Locale.ROOT).endsWith(".dae") && text(found).contains("Z_UP");
        String path = copy(found);
        if (loader == null) {
            loader = ModelLoader.withoutPictures(new Assets(project.resolve("assets")), text -> notes.add(text, 0));
        }
        try {
            Model draft = Draft.of(List.of(), () -> new Model("mesh", path));
            return new Mesh(path, loader.triangles(draft), zUp);
        } catch (IOException e) {
            notes.add("mesh " + given + " is left out: " + e.getMessage(), line);
            return null;
        }
    }

    /** Removes what was copied. */
    void undo() throws IOException {
        ProjectSwap.delete(project.resolve("assets").resolve(below));
    }

    private static String text(Path file) throws IOException {
        return Files.size(file) > MAX_TEXT ? "" : Files.readString(file, StandardCharsets.ISO_8859_1);
    }

    /** Returns the file of a path relative to the URDF, or in a package; null if there is none. */
    private Path find(String given) throws IOException {
        boolean packaged = given.matches("(package|model)://.*");
        String path = given.replaceFirst("^[a-z]+://", "").replace('\\', '/').replaceFirst("^/+", "");
        int slash = path.indexOf('/');
        List<Path> places = new ArrayList<>();
        for (Path at = folder; at != null && at.startsWith(top); at = at.getParent()) {
            places.add(at.resolve(path));
            if (slash > 0 && (packaged || !path.startsWith("."))) {
                places.add(at.resolve(path.substring(slash + 1)));
            }
        }
        for (Path place : places) {
            Path whole = place.normalize();
            if (whole.startsWith(top) && Files.isRegularFile(whole) && isBelowTop(whole)) {
                return whole;
            }
        }
        return null;
    }

    /** Copies a model with the materials and pictures that it names, and returns its path below assets. */
    private String copy(Path model) throws IOException {
        Path from = model.getParent();
        String to = folders.get(from);
        if (to == null) {
            String wanted = below + "/" + UrdfImport.legal(from.getFileName().toString());
            to = wanted;
            for (int i = 2; folders.containsValue(to); i++) {
                to = wanted + "_" + i;
            }
            folders.put(from, to);
        }
        Path folderOfCopies = Files.createDirectories(project.resolve("assets").resolve(to));
        List<Path> beside;
        try (Stream<Path> all = Files.list(from)) {
            beside = all.filter(each -> BESIDE.contains(ending(each))).sorted().collect(Collectors.toList());
        }
        StringBuilder words = new StringBuilder();
        if (!beside.isEmpty() && !ending(model).equals("stl")) {
            words.append(text(model));
        }
        Set<Path> copies = new HashSet<>(Set.of(model));
        for (Path each : beside) {
            if (ending(each).equals("mtl") && isNamed(each, words)) {
                words.append(text(each));
                copies.add(each);
            }
        }
        for (Path each : beside) {
            if (isNamed(each, words)) {
                copies.add(each);
            }
        }
        for (Path each : copies) {
            Path copy = folderOfCopies.resolve(each.equals(model) ? UrdfImport.legal(each.getFileName().toString())
                : each.getFileName().toString());
            if (!Files.exists(copy)) {
                Files.copy(each, copy);
            }
        }
        return to + "/" + UrdfImport.legal(model.getFileName().toString());
    }

    /** Whether a file is named in a text, and no link that leads out of the folders that may be read. */
    private boolean isNamed(Path file, StringBuilder words) throws IOException {
        return words.indexOf(file.getFileName().toString()) >= 0 && isBelowTop(file);
    }

    private boolean isBelowTop(Path file) throws IOException {
        return file.toRealPath().startsWith(top.toRealPath());
    }

    private static String ending(Path file) {
        String lower = file.getFileName().toString().toLowerCase(Locale.ROOT);
        return lower.substring(lower.lastIndexOf('.') + 1);
    }
}
