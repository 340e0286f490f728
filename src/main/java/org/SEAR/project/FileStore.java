package org.SEAR.project;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import org.SEAR.POJOs.Beam;
import org.SEAR.POJOs.ObjectStore;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.problems.Reasons;
import org.SEAR.project.xml.Xml;

/**
 * Keeps objects as XML files of the present SEARproject folder. Each file is written beside its place and then moved there: whole or not at all.
 * Any thread; waits while the project is replaced.
 */
public final class FileStore implements ObjectStore {
    /** Keeps the temporary files of two programs that work on one project apart. */
    private static final long PROCESS = ProcessHandle.current().pid();

    private final RobotOrder order = new RobotOrder();
    private final PartPlaces places = new PartPlaces();

    @Override
    public void write(SearObject object, boolean part) throws IOException {
        if (part && object.getFileName().equals(object.getName())) {
            places.take(object);
        }
        change(() -> {
            Path file = ProjectFolder.file(ProjectFolder.present(), part, object.getFileName());
            Files.createDirectories(file.getParent());
            refuseOtherCapitals(file, object.getName());
            writeAtomically(file, Xml.write(object).getBytes(StandardCharsets.UTF_8));
        });
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
            throw new IOException(Reasons.of(e), e);
        }
    }

    /**
     * Writes a file beside its place and moves it there: whole or not at all.
     *
     * @throws IOException if it can't be written; the old one is whole then
     */
    public static void writeAtomically(Path file, byte[] bytes) throws IOException {
        Path temporary = file.resolveSibling("." + file.getFileName() + "." + PROCESS + ProjectFolder.TEMPORARY);
        try {
            Files.write(temporary, bytes);
            Files.move(temporary, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException e) {
            Files.deleteIfExists(temporary);
            throw e;
        }
    }

    private static void refuseOtherCapitals(Path file, String name) throws IOException {
        String wanted = file.getFileName().toString();
        if (Files.exists(file)) {
            return;
        }
        try (DirectoryStream<Path> others = Files.newDirectoryStream(file.getParent())) {
            for (Path other : others) {
                if (other.getFileName().toString().equalsIgnoreCase(wanted)) {
                    throw new IllegalArgumentException("name is \"" + name + "\", legal: a name that differs from that of " + other
                        + " by more than capitals, since some systems take both for the same file");
                }
            }
        }
    }

    @Override
    public Integer orderOfRobot(String name) {
        return order.next(ProjectFolder.present(), name);
    }

    @Override
    public void remove(String file, boolean part) throws IOException {
        change(() -> {
            Path present = ProjectFolder.file(ProjectFolder.present(), part, file);
            if (file.indexOf('/') < 0) {
                Files.deleteIfExists(present);
            } else if (Files.exists(present)) {
                Files.delete(present);
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

    private static void deleteIfEmpty(Path folder) throws IOException {
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
