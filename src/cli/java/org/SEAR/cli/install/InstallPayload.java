package org.SEAR.cli.install;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** What there is to install: the distribution's {@code plugin/} folder with {@code sear.jar} and the plug-in's libraries. Any one thread. */
final class InstallPayload {
    static final String PLUGIN = "sear.jar";
    private final Path folder;

    /** @param folder holds sear.jar and the libraries under their original names */
    InstallPayload(Path folder) throws InstallException {
        this.folder = folder;
        if (!Files.isRegularFile(folder.resolve(PLUGIN))) {
            throw new InstallException("The distribution is incomplete: " + folder.resolve(PLUGIN)
                + " is missing. Unpack sear's zip again, or run ./gradlew installDist.");
        }
    }

    Path plugin() {
        return folder.resolve(PLUGIN);
    }

    /** Version in the plug-in's manifest, for example {@code 1.0.0}. */
    String version() throws IOException {
        try (JarFile jar = new JarFile(plugin().toFile())) {
            Manifest manifest = jar.getManifest();
            String version = manifest == null ? null : manifest.getMainAttributes().getValue("Implementation-Version");
            return version == null ? "0" : version;
        }
    }

    /** The plug-in's libraries, by file name. */
    List<Path> libraries() throws IOException {
        List<Path> jars = new ArrayList<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*.jar")) {
            for (Path file : files) {
                if (!file.getFileName().toString().equals(PLUGIN)) {
                    jars.add(file);
                }
            }
        }
        jars.sort(null);
        return jars;
    }

    /**
     * Whether MyRobotLab's own jar has the library in it.
     *
     * @param ownEntries names of that jar's entries
     */
    static boolean isInside(Path library, Set<String> ownEntries) throws IOException {
        try (ZipFile jar = new ZipFile(library.toFile())) {
            return jar.stream().map(ZipEntry::getName).filter(name -> name.endsWith(".class") && !name.contains("-info"))
                .findFirst().map(ownEntries::contains).orElse(false);
        }
    }

    /** {@code jme3-core-3.6.1-stable.jar} is version {@code 3.6.1-stable}; empty where the name has none. */
    static String version(String fileName) {
        return fileName.replaceAll("\\.jar$", "").replaceAll("-natives-.*$", "").replaceAll("^.*?-(?=\\d)|^\\D*$", "");
    }

    /** {@code jme3-core-3.6.1-stable.jar} is artifact {@code jme3-core}; a natives classifier belongs to the artifact. */
    static String artifact(String fileName) {
        String base = fileName.replaceAll("\\.jar$", "");
        String natives = base.replaceAll("^.*?(-natives-.*)$", "$1");
        String name = base.replaceAll("-natives-.*$", "").replaceAll("-\\d.*$", "");
        return name + (natives.equals(base) ? "" : natives);
    }
}
