package org.SEAR.cli.install;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** What an installation put where, kept in {@code libraries/sear-install.json}, so that it can be taken out to the byte. Paths use '/'. */
final class Receipt {
    private static final ObjectMapper MAPPER = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);

    /** Version of the plug-in that was installed. */
    public String version = "0";
    /** SHA-256 of each file that was not there before. */
    public Map<String, String> added = new TreeMap<>();
    /** SHA-256 of each file that was there before, as it was written. */
    public Map<String, String> changed = new TreeMap<>();
    /** The bytes that the changed files had before. */
    public Map<String, byte[]> originals = new TreeMap<>();
    /** SHA-256 of each jar of MyRobotLab's that made room for one of ours, by its name; it lies in {@code libraries/sear-replaced}. */
    public Map<String, String> replaced = new TreeMap<>();
    /** Folders that were not there before. */
    public Set<String> folders = new TreeSet<>();

    /** The receipt of an installation, or null where there is none. */
    static Receipt read(Path file) throws IOException, InstallException {
        try {
            return Files.exists(file) ? MAPPER.readValue(Files.readAllBytes(file), Receipt.class) : null;
        } catch (JsonProcessingException e) {
            throw new InstallException(file + " cannot be read (" + e.getOriginalMessage()
                + "). Delete it and install again; nothing was changed.", e);
        }
    }

    byte[] bytes() throws JsonProcessingException {
        return (MAPPER.writeValueAsString(this) + "\n").getBytes(StandardCharsets.UTF_8);
    }
}
