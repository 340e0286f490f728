package org.SEAR.cli.install;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Files to write and to delete below one folder, done as a whole or not at all: new bytes are first written beside their place, then moved in; when
 * anything fails, what was done is undone, and when the program is killed, a {@link InstallJournal} tells the next call. Any one thread.
 */
final class InstallPlan {
    private static final String ROOT = "root";
    private final Path root;
    private final Map<String, byte[]> writes = new TreeMap<>();
    private final Set<String> deletes = new TreeSet<>();
    private final List<String> notes = new ArrayList<>();
    private final Set<String> emptied = new TreeSet<>();
    private final List<String> remarks = new ArrayList<>();
    private final List<Path> leftovers = new ArrayList<>();
    private Runnable beforeStep = () -> { };

    InstallPlan(Path root) {
        this.root = root;
    }

    /**
     * Lets a file have these bytes.
     *
     * @param path relative to the root, with '/'
     */
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
        if (!paths.isEmpty()) {
            touched.add(root); // for the journal
        }
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

    /**
     * Does it.
     *
     * @throws IOException after everything was put back as it was; what could not be put back is among its suppressed exceptions
     */
    void apply() throws IOException {
        InstallJournal journal = journal();
        for (String path : journal.changed) {
            Files.deleteIfExists(sibling(path, InstallJournal.KEPT)); // left by an update while another program had it open
        }
        journal.write(root, beforeStep);
        try {
            carryOut(journal);
        } catch (IOException e) {
            try {
                journal.undo(root);
                InstallJournal.delete(root);
            } catch (IOException more) {
                e.addSuppressed(more);
            }
            throw e;
        }
        journal.done = true;
        journal.write(root, beforeStep);
        beforeStep.run();
        leftovers.addAll(journal.finish(root));
        beforeStep.run();
        InstallJournal.delete(root);
    }

    private InstallJournal journal() {
        InstallJournal journal = new InstallJournal();
        for (String path : writes.keySet()) {
            (Files.exists(root.resolve(path)) ? journal.changed : journal.fresh).add(path);
        }
        journal.changed.addAll(deletes);
        journal.folders.addAll(newFolders());
        journal.emptied.addAll(emptied);
        return journal;
    }

    private void carryOut(InstallJournal journal) throws IOException {
        for (String folder : journal.folders) {
            beforeStep.run();
            giveToOwner(Files.createDirectory(root.resolve(folder)));
        }
        for (Map.Entry<String, byte[]> write : writes.entrySet()) {
            beforeStep.run();
            giveToOwner(Files.write(sibling(write.getKey(), InstallJournal.STAGED), write.getValue()));
        }
        for (String path : journal.changed) {
            beforeStep.run();
            Files.move(root.resolve(path), sibling(path, InstallJournal.KEPT), StandardCopyOption.ATOMIC_MOVE);
        }
        for (String path : writes.keySet()) {
            beforeStep.run();
            Files.move(sibling(path, InstallJournal.STAGED), root.resolve(path), StandardCopyOption.ATOMIC_MOVE);
        }
    }

    /** Called before each change of the disk, so that a test can end the call there. */
    void setBeforeStep(Runnable action) {
        beforeStep = action;
    }

    /**
     * Folders to delete in the end, where they are empty then.
     *
     * @param folders relative to the root
     */
    void deleteEmptied(Set<String> folders) {
        emptied.addAll(folders);
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

    private Path sibling(String path, String suffix) {
        Path file = root.resolve(path);
        return file.resolveSibling(file.getFileName() + suffix);
    }
}
