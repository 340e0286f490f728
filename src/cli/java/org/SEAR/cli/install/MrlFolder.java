package org.SEAR.cli.install;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** A MyRobotLab installation on disk: the folder with {@code myrobotlab.jar}. Any one thread. */
final class MrlFolder {
    private static final String JAR = "myrobotlab.jar";
    private final Path root;

    private MrlFolder(Path root) {
        this.root = root;
    }

    /** The installation in {@code given}, or in the only folder right below it that has one. */
    static MrlFolder find(Path given) throws InstallException {
        if (!Files.isDirectory(given)) {
            throw new InstallException(given + " is not a folder. Name the folder that holds MyRobotLab's " + JAR + ".");
        }
        if (Files.isRegularFile(given.resolve(JAR))) {
            return new MrlFolder(given.toAbsolutePath().normalize());
        }
        List<Path> below = new ArrayList<>();
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(given, Files::isDirectory)) {
            for (Path folder : folders) {
                if (Files.isRegularFile(folder.resolve(JAR))) {
                    below.add(folder);
                }
            }
        } catch (IOException e) {
            throw new InstallException("Cannot look into " + given + ": " + e.getMessage(), e);
        }
        if (below.size() != 1) {
            throw new InstallException(given + (below.isEmpty() ? " holds no " + JAR + ". Name the folder that does."
                : " holds several MyRobotLabs: " + below + ". Name one of them."));
        }
        return new MrlFolder(below.get(0).toAbsolutePath().normalize());
    }

    Path root() {
        return root;
    }

    Path libraries() {
        return root.resolve("libraries");
    }

    Path jars() {
        return libraries().resolve("jar");
    }

    Path serviceData() {
        return libraries().resolve("serviceData.json");
    }

    Path receipt() {
        return libraries().resolve("sear-install.json");
    }

    /** MRL unpacks its own resources only while this folder is missing, so nobody may create it before. */
    Path resources() {
        return root.resolve("resource");
    }

    /** The ymls of services, one folder a configuration. */
    List<Path> serviceConfigs() throws IOException {
        List<Path> files = new ArrayList<>();
        Path configs = root.resolve("data").resolve("config");
        if (Files.isDirectory(configs)) {
            try (DirectoryStream<Path> folders = Files.newDirectoryStream(configs, Files::isDirectory)) {
                for (Path folder : folders) {
                    try (DirectoryStream<Path> ymls = Files.newDirectoryStream(folder, "*.yml")) {
                        ymls.forEach(files::add);
                    }
                }
            }
        }
        files.sort(null);
        return files;
    }

    /** Names of all entries of {@code myrobotlab.jar}: a library whose classes are in there is not added again. */
    Set<String> ownEntries() throws InstallException {
        Set<String> names = new HashSet<>();
        try (ZipFile jar = new ZipFile(root.resolve(JAR).toFile())) {
            jar.stream().map(ZipEntry::getName).forEach(names::add);
        } catch (IOException e) {
            throw new InstallException(root.resolve(JAR) + " is not a readable jar (" + e.getMessage() + "). Reinstall MyRobotLab.", e);
        }
        return names;
    }

    /** Refuses while a MyRobotLab runs from this folder: it has the jars open and writes the same files. */
    void refuseIfRunning() throws InstallException {
        Set<Long> callers = new HashSet<>();
        for (Optional<ProcessHandle> caller = Optional.of(ProcessHandle.current()); caller.isPresent(); caller = caller.get().parent()) {
            callers.add(caller.get().pid()); // a shell whose command line names myrobotlab.jar and calls this program is no MyRobotLab
        }
        Optional<ProcessHandle> running = ProcessHandle.allProcesses().filter(process -> !callers.contains(process.pid()))
            .filter(this::runsFromHere).findFirst();
        if (running.isPresent()) {
            throw new InstallException("MyRobotLab is running from " + root + " (process " + running.get().pid() + "). Shut it down and call again.");
        }
        try (FileChannel jar = FileChannel.open(root.resolve(JAR), StandardOpenOption.READ, StandardOpenOption.WRITE)) {
            jar.size();
        } catch (IOException e) {
            if (Files.isWritable(root.resolve(JAR))) {
                throw new InstallException(root.resolve(JAR) + " is in use (" + e.getMessage() + "). Shut MyRobotLab down and call again.", e);
            }
        }
    }

    private boolean runsFromHere(ProcessHandle process) {
        String command = String.join(" ", process.info().arguments().orElse(new String[0])) + process.info().commandLine().orElse("");
        if (!command.contains("org.myrobotlab.service.Runtime") && !command.contains(JAR)) {
            return false;
        }
        if (command.contains(root.toString())) {
            return true;
        }
        try {
            return Files.isSameFile(root, Path.of("/proc", Long.toString(process.pid()), "cwd"));
        } catch (IOException | SecurityException e) {
            return false; // no such view of processes on this system: the command line was all there is to judge by
        }
    }

    /** Refuses when something that has to be written can't be: a file, or a folder that gets or loses files. */
    void refuseIfNotWritable(InstallPlan plan) throws InstallException {
        for (Path path : plan.touched()) {
            if (!Files.isWritable(path)) {
                throw new InstallException("No permission to write into " + path + ". Run the command as the user who owns it.");
            }
        }
        for (Path folder : new Path[] {libraries(), jars()}) {
            if (Files.exists(folder) && !Files.isDirectory(folder)) {
                throw new InstallException(folder + " is a file, and has to be a folder. Rename it and call again.");
            }
        }
    }
}
