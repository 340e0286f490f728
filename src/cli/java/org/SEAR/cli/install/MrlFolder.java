// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** A MyRobotLab installation on disk: the folder with {@code myrobotlab.jar}. Any one thread. */
final class MrlFolder {
    private static final String JAR = "myrobotlab.jar";
    /** The folder with {@code myrobotlab.jar}. */
    final Path root;

    /** Finds the installation in {@code given}, or in its only subfolder that has one. */
    MrlFolder(Path given) throws InstallException, IOException {
        if (!Files.isDirectory(given)) {
            throw new InstallException(given + " is not a folder. Give the folder with MyRobotLab's " + JAR + ".");
        }
        List<Path> found = isMrl(given) ? List.of(given) : list(given, "*").stream().filter(MrlFolder::isMrl)
            .collect(Collectors.toList());
        if (found.size() != 1) {
            throw new InstallException(given + (found.isEmpty() ? " contains no " + JAR + ". Give the folder that does."
                : " contains several MyRobotLabs: " + found + ". Give one of them."));
        }
        root = found.get(0).toAbsolutePath().normalize();
    }

    private static boolean isMrl(Path folder) {
        return Files.isRegularFile(folder.resolve(JAR));
    }

    /** Returns the content of a folder, sorted by name; empty if there is no such folder. */
    static List<Path> list(Path folder, String glob) throws IOException {
        List<Path> content = new ArrayList<>();
        if (Files.isDirectory(folder)) {
            try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, glob)) {
                files.forEach(content::add);
            }
        }
        content.sort(null);
        return content;
    }

    /** Returns the names of all entries of {@code myrobotlab.jar}. */
    Set<String> ownEntries() throws InstallException {
        try (ZipFile jar = new ZipFile(root.resolve(JAR).toFile())) {
            return jar.stream().map(ZipEntry::getName).collect(Collectors.toSet());
        } catch (IOException e) {
            throw new InstallException(root.resolve(JAR) + " is not a readable jar (" + e.getMessage()
                + "). Reinstall MyRobotLab.");
        }
    }

    /** Throws if a MyRobotLab runs from this folder: it has the jars open and writes the same files. */
    void refuseIfRunning() throws InstallException {
        Set<ProcessHandle> callers = Stream.iterate(ProcessHandle.current(), Objects::nonNull,
            process -> process.parent().orElse(null))
            .collect(Collectors.toSet()); // excludes a calling shell whose command line names myrobotlab.jar
        Optional<ProcessHandle> running = ProcessHandle.allProcesses().filter(process -> !callers.contains(process))
            .filter(this::runsFromHere).findFirst();
        if (running.isPresent()) {
            throw new InstallException("MyRobotLab is running from " + root + " (process " + running.get().pid()
                + "). Shut it down and try again.");
        }
        try (FileChannel jar = FileChannel.open(root.resolve(JAR), StandardOpenOption.READ, StandardOpenOption.WRITE)) {
            jar.size();
        } catch (IOException e) {
            if (Files.isWritable(root.resolve(JAR))) {
                throw new InstallException(root.resolve(JAR) + " is in use (" + e.getMessage()
                    + "). Shut MyRobotLab down and try again.");
            }
        }
    }

    private boolean runsFromHere(ProcessHandle process) {
        String command = String.join(" ", process.info().arguments().orElse(new String[0])) + process.info()
            .commandLine().orElse("");
        if (!command.contains("org.myrobotlab.service.Runtime") && !command.contains(JAR)) {
            return false;
        }
        try {
            return command.contains(root.toString())
                || Files.isSameFile(root, Path.of("/proc", Long.toString(process.pid()), "cwd"));
        } catch (IOException | SecurityException e) {
            return false; // no process folders on this system: the command line must do
        }
    }
}
