package org.SEAR.cli.install;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
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
    private final Path root;
    private final Map<String, byte[]> writes = new TreeMap<>();
    private final Set<String> deletes = new TreeSet<>();
    private final List<String> notes = new ArrayList<>();

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

    /** Does it. @throws IOException after everything was put back as it was */
    void apply() throws IOException {
        Deque<Undo> undo = new ArrayDeque<>();
        try {
            for (String folder : newFolders()) {
                Files.createDirectory(root.resolve(folder));
                undo.push(() -> Files.delete(root.resolve(folder)));
            }
            for (Map.Entry<String, byte[]> write : writes.entrySet()) {
                Path staged = sibling(write.getKey(), STAGED);
                undo.push(() -> Files.deleteIfExists(staged));
                Files.write(staged, write.getValue());
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
        for (String path : writes.keySet()) {
            Files.deleteIfExists(sibling(path, KEPT));
        }
        for (String path : deletes) {
            Files.deleteIfExists(sibling(path, KEPT));
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
