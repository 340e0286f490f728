// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.function.Supplier;
import org.SEAR.POJOs.Beam;
import org.SEAR.POJOs.ObjectStore;
import org.SEAR.POJOs.SearObject;
import org.SEAR.files.AtomicFile;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.problems.FileReasons;
import org.SEAR.project.xml.Xml;

/**
 * Stores objects as XML files of the current SEARproject folder. A write is atomic: a temporary file beside the target
 * is moved into place. Any thread; waits while the project is being replaced.
 */
public final class FileStore implements ObjectStore {
    private final PartPlaces places = new PartPlaces();
    /** Changes since the start of {@link #whole}; null outside of it. */
    private final ThreadLocal<Undo> undo = new ThreadLocal<>();

    @Override
    public void write(SearObject object, boolean part) throws IOException {
        if (part && object.getFileName().equals(object.getName())) {
            places.take(object, this::put);
        }
        change(() -> {
            Path file = ProjectFolder.file(ProjectFolder.present(), part, object.getFileName());
            Files.createDirectories(file.getParent());
            refuseOtherCapitals(file, object.getName());
            put(file, Xml.write(object).getBytes(StandardCharsets.UTF_8));
        });
    }

    /** @param bytes null to remove the file */
    private void put(Path file, byte[] bytes) throws IOException {
        Undo log = undo.get();
        if (log != null) {
            log.note(file);
        }
        if (bytes == null) {
            Files.deleteIfExists(file);
        } else {
            Files.createDirectories(file.getParent());
            AtomicFile.write(file, bytes);
        }
    }

    @Override
    public <T> T whole(Supplier<T> maker) {
        if (undo.get() != null) {
            return maker.get();
        }
        Undo log = new Undo();
        undo.set(log);
        places.begin();
        boolean done = false;
        try {
            T made = maker.get();
            done = true;
            return made;
        } finally {
            undo.remove();
            if (!done) {
                putBack(log);
            }
        }
    }

    private void putBack(Undo log) {
        try {
            change(log::putBack);
            places.putBack();
        } catch (IOException e) {
            throw new UncheckedIOException("the project in " + ProjectFolder.present() + " could not be restored: "
                + e.getMessage(), e);
        }
    }

    @Override
    public String partName(String robot, String part) throws IOException {
        Path project = ProjectFolder.present();
        boolean taken = isThere(project.resolve(ProjectFolder.ENVIRONMENT), part) != null;
        Path file = isThere(project.resolve(ProjectFolder.ROBOT), part);
        return taken || file != null && FiledRobots.read(file) != null ? robot + " " + part : part;
    }

    /** Returns the file of a name, case-insensitive; null if there is none. */
    private static Path isThere(Path folder, String name) throws IOException {
        if (!Files.isDirectory(folder)) {
            return null;
        }
        String wanted = name + ProjectFolder.XML;
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, file -> file.getFileName().toString()
            .equalsIgnoreCase(wanted))) {
            Iterator<Path> found = files.iterator();
            return found.hasNext() ? found.next() : null;
        }
    }

    @Override
    public boolean replaces(String name) throws IOException {
        return Files.exists(ProjectFolder.file(ProjectFolder.present(), false, name))
            || Files.exists(ProjectFolder.file(ProjectFolder.present(), true, name)) && !places.givesWay(name);
    }

    private static void change(ProjectSwap.Change change) throws IOException {
        try {
            ProjectSwap.change(ProjectFolder.present(), change);
        } catch (FileSystemException e) {
            throw new IOException(FileReasons.of(e), e);
        }
    }

    private static void refuseOtherCapitals(Path file, String name) throws IOException {
        String wanted = TextRule.onAnySystem(file.getFileName().toString());
        if (Files.exists(file)) {
            return;
        }
        try (DirectoryStream<Path> others = Files.newDirectoryStream(file.getParent())) {
            for (Path other : others) {
                if (TextRule.onAnySystem(other.getFileName().toString()).equals(wanted)) {
                    throw new IllegalArgumentException(
                        "name is \"" + name + "\", legal: a name that differs from that of " + other
                        + " by more than capitals or accents' spelling, since some systems take both for "
                            + "the same file");
                }
            }
        }
    }

    @Override
    public Integer orderOfRobot(String name) {
        return FiledRobots.nextPlace(ProjectFolder.present(), name);
    }

    @Override
    public boolean keeps(String file, boolean part) {
        return Files.exists(ProjectFolder.file(ProjectFolder.present(), part, file));
    }

    @Override
    public void remove(String file, boolean part) throws IOException {
        change(() -> {
            Path present = ProjectFolder.file(ProjectFolder.present(), part, file);
            boolean was = Files.exists(present);
            put(present, null);
            if (was && file.indexOf('/') >= 0) {
                deleteIfEmpty(present.getParent());
            }
        });
    }

    @Override
    public void removeOwn(SearObject part) throws IOException {
        if (places.has(part)) {
            remove(part.getName(), true);
        }
    }

    static void deleteIfEmpty(Path folder) throws IOException {
        boolean empty;
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
            empty = !files.iterator().hasNext();
        }
        if (empty) {
            Files.delete(folder);
        }
    }

    @Override
    public Beam beam(String name) {
        return new BeamLibrary(ProjectFolder.present()).get(name);
    }

    @Override
    public List<String> beamNames() {
        return new BeamLibrary(ProjectFolder.present()).names();
    }
}
