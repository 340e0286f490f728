package org.myrobotlab.service.link;

import java.io.IOException;
import java.io.InputStream;
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
 * Puts a service's panel, icon, example script and example projects where MyRobotLab serves them from: below its resource root, on the disk. Files
 * that are missing or that an older version put there are written; files that the user has changed are left alone. Never
 * creates the resource root itself, whose absence makes MyRobotLab unpack its own.
 */
public final class PanelFiles {
    private static final Logger log = LoggerFactory.getLogger(PanelFiles.class);
    private static final List<String> FILES = Arrays.asList("%s.png", "%s/%s.py", "WebGui/app/service/views/%sGui.html",
        example("car"), example("line"), example("maze"), example("mountain"), example("office"), example("ramps"), example("rover"),
        example("sensors"), example("turret"),
        script("Gui"), script("Balance"), script("Beams"), script("Building"), script("Edits"), script("Geometry"), script("Ground"),
        script("Handles"), script("Inspector"), script("Item"), script("Looks"), script("Map"), script("Palette"), script("Panel"), script("Places"),
        script("Plot"), script("Pointing"), script("Projects"), script("Records"), script("Replay"), script("Robots"), script("Scene"),
        script("Script"),
        script("Terrain"), script("Views"), script("Words"), script("Workspace"), script("World"));
    /** Where the jar has them. */
    private static final String IN_JAR = "/resource/";
    /** Below the resource root: what was written, by file name, as SHA-256. */
    private static final String RECORD = ".sear-files.properties";

    private PanelFiles() {
    }

    private static String example(String name) {
        return "%s/" + name + ".sear";
    }

    /** A file of a panel's script: {@code Gui} is the one that MyRobotLab loads, the others are loaded by it. */
    private static String script(String part) {
        return "WebGui/app/service/js/%s" + part + ".js";
    }

    /** Installs the files of a service class. Never throws: what goes wrong is logged. */
    public static void install(Class<? extends Service<?>> type) {
        try {
            install(type, Paths.get(Service.getResourceRoot()));
        } catch (IOException | RuntimeException e) {
            log.warn("the panel files of {} could not be written: {}", type.getSimpleName(), e.toString());
        }
    }

    /** Installs the files of a class below a resource root, if that is there. */
    static synchronized void install(Class<?> type, Path root) throws IOException {
        if (!Files.isDirectory(root)) {
            return;
        }
        Properties record = read(root.resolve(RECORD));
        boolean changed = false;
        for (String pattern : FILES) {
            String name = pattern.replace("%s", type.getSimpleName());
            try (InputStream in = type.getResourceAsStream(IN_JAR + name)) {
                changed |= in != null && update(root, name, in.readAllBytes(), record);
            }
        }
        if (changed) {
            write(root.resolve(RECORD), record);
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

    private static Properties read(Path file) throws IOException {
        Properties record = new Properties();
        if (Files.exists(file)) {
            try (InputStream in = Files.newInputStream(file)) {
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

    private static String hash(byte[] bytes) {
        try {
            StringBuilder text = new StringBuilder();
            for (byte b : MessageDigest.getInstance("SHA-256").digest(bytes)) {
                text.append(String.format("%02x", b));
            }
            return text.toString();
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("this Java has no SHA-256", e);
        }
    }
}
