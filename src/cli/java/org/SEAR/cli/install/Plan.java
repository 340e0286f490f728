package org.SEAR.cli.install;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Files to write and to delete below one folder, done as a whole or not at all: new bytes are first written beside their place, then moved in; when
 * anything fails, what was done is undone. Any one thread.
 */
final class Plan {
    private static final String STAGED = ".sear-new";
    private static final String KEPT = ".sear-old";
    private static final String ROOT = "root";
    private final Path root;
    private final Map<String, byte[]> writes = new TreeMap<>();
    private final Set<String> deletes = new TreeSet<>();
    private final List<String> notes = new ArrayList<>();
    private final List<String> remarks = new ArrayList<>();
    private final List<Path> leftovers = new ArrayList<>();

    Plan(Path root) {
        this.root = root;
    }

    /** Lets a file have these bytes. @param path relative to the root, with '/' */
    void write(String path, byte[] bytes) throws IOException {
        Path file = root.resolve(path);
        if (!Files.exists(file)) {
            notes.add("add     " + path);
        } else if (!java.util.Arrays.equals(Files.readAllBytes(file), bytes)) {
            notes.add("change  " + path);
        } else {
            return;
        }
        writes.put(path, bytes);
    }

    void delete(String path) {
        if (Files.exists(root.resolve(path))) {
            deletes.add(path);
            notes.add("delete  " + path);
        }
    }

    /** Says something about what is left alone. */
    void note(String text) {
        notes.add(text);
    }

    /** Says something that the user is left with when all is done. */
    void remark(String text) {
        remarks.add(text);
    }

    /** What the user is left with, a line each. */
    List<String> remarks() {
        return remarks;
    }

    boolean isEmpty() {
        return writes.isEmpty() && deletes.isEmpty();
    }

    /** What will be done, a line each. */
    List<String> describe() {
        return notes;
    }

    /** Folders that have to be made for the writes, relative to the root. */
    Set<String> newFolders() {
        Set<String> folders = new TreeSet<>();
        for (String path : writes.keySet()) {
            for (Path folder = Path.of(path).getParent(); folder != null && !Files.exists(root.resolve(folder)); folder = folder.getParent()) {
                folders.add(folder.toString().replace('\\', '/'));
            }
        }
        return folders;
    }

    /** What the user needs the right to write for this: files that are changed, and the folders that get or lose files. */
    Set<Path> touched() {
        Set<String> paths = new TreeSet<>(writes.keySet());
        paths.addAll(deletes);
        Set<Path> touched = new TreeSet<>();
        for (String path : paths) {
            Path folder = root.resolve(path).getParent();
            while (!Files.exists(folder)) {
                folder = folder.getParent();
            }
            touched.add(folder);
        }
        writes.keySet().stream().map(root::resolve).filter(Files::exists).forEach(touched::add);
        return touched;
    }

    /** Does it. @throws IOException after everything was put back as it was; what could not be put back is among its suppressed exceptions */
    void apply() throws IOException {
        Deque<Undo> undo = new ArrayDeque<>();
        try {
            for (String folder : newFolders()) {
                giveToOwner(Files.createDirectory(root.resolve(folder)));
                undo.push(() -> Files.delete(root.resolve(folder)));
            }
            for (Map.Entry<String, byte[]> write : writes.entrySet()) {
                Path staged = sibling(write.getKey(), STAGED);
                undo.push(() -> Files.deleteIfExists(staged));
                giveToOwner(Files.write(staged, write.getValue()));
            }
            for (String path : deletes) {
                setAside(path, undo);
            }
            for (String path : writes.keySet()) {
                if (Files.exists(root.resolve(path))) {
                    setAside(path, undo);
                }
                Files.move(sibling(path, STAGED), root.resolve(path), StandardCopyOption.ATOMIC_MOVE);
                undo.push(() -> Files.delete(root.resolve(path)));
            }
        } catch (IOException e) {
            for (Undo step : undo) {
                try {
                    step.run();
                } catch (IOException more) {
                    e.addSuppressed(more);
                }
            }
            throw e;
        }
        forgetKept();
    }

    /** All is done; an old file that another program still holds open stays beside the new one, where nothing reads it. */
    private void forgetKept() {
        Set<String> paths = new TreeSet<>(writes.keySet());
        paths.addAll(deletes);
        for (String path : paths) {
            Path kept = sibling(path, KEPT);
            try {
                Files.deleteIfExists(kept);
            } catch (IOException e) {
                leftovers.add(kept);
            }
        }
    }

    /** Old files that could not be deleted, after {@link #apply}. */
    List<Path> leftovers() {
        return leftovers;
    }

    /** What root writes belongs to the owner of the MyRobotLab, who has to be able to change it. */
    private void giveToOwner(Path file) throws IOException {
        PosixFileAttributeView view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (view != null && ROOT.equals(view.getOwner().getName())) {
            PosixFileAttributes owner = Files.readAttributes(root, PosixFileAttributes.class);
            view.setOwner(owner.owner());
            view.setGroup(owner.group());
        }
    }

    private void setAside(String path, Deque<Undo> undo) throws IOException {
        Path kept = sibling(path, KEPT);
        Files.move(root.resolve(path), kept, StandardCopyOption.ATOMIC_MOVE);
        undo.push(() -> Files.move(kept, root.resolve(path), StandardCopyOption.ATOMIC_MOVE));
    }

    private Path sibling(String path, String suffix) {
        Path file = root.resolve(path);
        return file.resolveSibling(file.getFileName() + suffix);
    }

    /** One step back. */
    private interface Undo {
        void run() throws IOException;
    }
}
