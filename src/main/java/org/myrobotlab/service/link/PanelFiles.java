// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.List;
import java.util.Properties;
import org.SEAR.files.AtomicFile;
import org.myrobotlab.framework.Service;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Installs the services' panels, icons, example scripts and example projects below MyRobotLab's resource root. Writes
 * files that are missing or unchanged since an older version, and deletes files that only an older version had. Leaves
 * files alone that the user has changed. Never creates the resource root: MyRobotLab unpacks its own resources only if
 * the root is missing.
 */
public final class PanelFiles {
    private static final Logger log = LoggerFactory.getLogger(PanelFiles.class);
    /** Resource in the jar that lists all panel files, one per line; written by the build. */
    private static final String LIST = "/org/SEAR/panel-files.txt";
    /** Folder of the panel files in the jar. */
    private static final String IN_JAR = "/resource/";
    /** Name of the list of installed files, below the resource root. */
    public static final String RECORD = ".sear-files.properties";

    private PanelFiles() {
    }

    /** Installs the files of all panels. Never throws: logs failures. */
    public static void install() {
        try {
            install(Paths.get(Service.getResourceRoot()));
        } catch (IOException | RuntimeException e) {
            log.warn("SEAR could not write the panel files: {}", e.toString());
        }
    }

    /** Installs the files below a resource root; does nothing if the root is missing. */
    static synchronized void install(Path root) throws IOException {
        if (!Files.isDirectory(root)) {
            return;
        }
        Properties record = record(root);
        boolean changed = false;
        List<String> names = Arrays.asList(new String(bytes(LIST), StandardCharsets.UTF_8).split("\n"));
        for (String name : names) {
            changed |= update(root, name, bytes(IN_JAR + name), record);
        }
        for (String name : record.stringPropertyNames()) {
            changed |= !names.contains(name) && drop(root.resolve(name), record.remove(name));
        }
        if (changed) {
            write(root.resolve(RECORD), record);
        }
    }

    private static byte[] bytes(String name) throws IOException {
        try (InputStream in = PanelFiles.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new FileNotFoundException(name + " is missing from SEAR's jar: install SEAR again");
            }
            return in.readAllBytes();
        }
    }

    private static boolean update(Path root, String name, byte[] ours, Properties record) throws IOException {
        Path file = root.resolve(name);
        String hash = hash(ours);
        if (Files.exists(file)) {
            String present = hash(Files.readAllBytes(file));
            if (present.equals(hash)) {
                return !hash.equals(record.put(name, hash));
            }
            if (!present.equals(record.getProperty(name))) {
                log.info("SEAR keeps {}: the user has changed it", file);
                return false;
            }
        }
        Files.createDirectories(file.getParent());
        AtomicFile.write(file, ours);
        record.put(name, hash);
        return true;
    }

    /** Deletes a file of an older version unless the user has changed it. Returns true: the record has changed. */
    private static boolean drop(Path file, Object hash) throws IOException {
        if (Files.exists(file) && hash(Files.readAllBytes(file)).equals(hash)) {
            Files.delete(file);
        }
        return true;
    }

    /** Returns the SHA-256 of each installed file by file name; empty if nothing was installed. */
    public static Properties record(Path root) throws IOException {
        Properties record = new Properties();
        if (Files.exists(root.resolve(RECORD))) {
            try (InputStream in = Files.newInputStream(root.resolve(RECORD))) {
                record.load(in);
            }
        }
        return record;
    }

    private static void write(Path file, Properties record) throws IOException {
        StringBuilder text = new StringBuilder("# Files that SEAR installed and their SHA-256, to recognise files that "
            + "the user has changed.\n");
        record.stringPropertyNames().stream().sorted()
            .forEach(name -> text.append(name).append('=').append(record.getProperty(name)).append('\n'));
        AtomicFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    /** Returns the SHA-256 in hexadecimal digits. */
    public static String hash(byte[] bytes) {
        try {
            return String.format("%064x", new BigInteger(1, MessageDigest.getInstance("SHA-256").digest(bytes)));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("this Java has no SHA-256", e);
        }
    }
}
