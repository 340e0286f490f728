package org.myrobotlab.service.link;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.List;
import java.util.Properties;
import org.myrobotlab.framework.Service;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Puts the services' panels, icons, example scripts and example projects where MyRobotLab serves them from: below its resource root, on the disk.
 * Files that are missing or that an older version put there are written, those that only the older one had go; files that the user has changed are
 * left alone. Never creates the resource root itself, whose absence makes MyRobotLab unpack its own.
 */
public final class PanelFiles {
    private static final Logger log = LoggerFactory.getLogger(PanelFiles.class);
    /** In the jar: the files of all panels, a line each, as the build found them. */
    private static final String LIST = "/org/SEAR/panel-files.txt";
    /** Where the jar has them. */
    private static final String IN_JAR = "/resource/";
    /** Below the resource root: the list of what was written. */
    public static final String RECORD = ".sear-files.properties";

    private PanelFiles() {
    }

    /** Installs the files of all panels, which share some. Never throws: what goes wrong is logged. */
    public static void install() {
        try {
            install(Paths.get(Service.getResourceRoot()));
        } catch (IOException | RuntimeException e) {
            log.warn("the panel files could not be written: {}", e.toString());
        }
    }

    /** Installs the files below a resource root, if that is there. */
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
                throw new FileNotFoundException(name + " is not in the jar of SEAR: install it again");
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
                log.info("{} was changed by the user and is left alone", file);
                return false;
            }
        }
        Files.createDirectories(file.getParent());
        Path temporary = Files.createTempFile(file.getParent(), "sear", ".tmp");
        try {
            Files.write(temporary, ours);
            Files.move(temporary, file, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(temporary);
        }
        record.put(name, hash);
        return true;
    }

    /** Deletes what only an older version had, unless the user has changed it; true in any case: it is recorded no more. */
    private static boolean drop(Path file, Object hash) throws IOException {
        if (Files.exists(file) && hash(Files.readAllBytes(file)).equals(hash)) {
            Files.delete(file);
        }
        return true;
    }

    /** What was written below a resource root, by file name, as SHA-256; empty where nothing was. */
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
        StringBuilder text = new StringBuilder("# What SEAR put here, to tell its own files from changed ones.\n");
        record.stringPropertyNames().stream().sorted().forEach(name -> text.append(name).append('=').append(record.getProperty(name)).append('\n'));
        Files.writeString(file, text);
    }

    /** SHA-256 in hexadecimal digits. */
    public static String hash(byte[] bytes) {
        try {
            return String.format("%064x", new BigInteger(1, MessageDigest.getInstance("SHA-256").digest(bytes)));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("this Java has no SHA-256", e);
        }
    }
}
