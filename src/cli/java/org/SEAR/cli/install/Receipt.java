// SPDX-License-Identifier: Apache-2.0
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

/**
 * List of all changes of an installation, in {@code libraries/sear-install.json}; allows a removal that restores every
 * byte. The journal of a running call is a receipt with originals only. Paths use '/'.
 */
final class Receipt {
    private static final ObjectMapper MAPPER = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);

    /** Version of the plug-in; null if none is installed. */
    public String version;
    /** SHA-256 of each new file. */
    public Map<String, String> added = new TreeMap<>();
    /** SHA-256 of each changed file, as written. */
    public Map<String, String> changed = new TreeMap<>();
    /** Former contents of the changed files; in a journal null for a new file. */
    public Map<String, byte[]> originals = new TreeMap<>();
    /** SHA-256 of MyRobotLab's replaced jars, by name; the jars are in {@code libraries/sear-replaced}. */
    public Map<String, String> replaced = new TreeMap<>();
    /** New folders; written by earlier versions only. */
    public Set<String> folders = Set.of();

    /**
     * Reads a receipt; empty if there is no file.
     *
     * @param advice for an unreadable file
     */
    static Receipt read(Path file, String advice) throws IOException, InstallException {
        try {
            return Files.exists(file) ? MAPPER.readValue(Files.readAllBytes(file), Receipt.class) : new Receipt();
        } catch (JsonProcessingException e) {
            throw new InstallException(file + " can't be read (" + e.getOriginalMessage() + "). " + advice);
        }
    }

    byte[] bytes() throws JsonProcessingException {
        return (MAPPER.writeValueAsString(this) + "\n").getBytes(StandardCharsets.UTF_8);
    }
}
