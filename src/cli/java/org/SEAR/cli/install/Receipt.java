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
 * What an installation put where, kept in {@code libraries/sear-install.json}, so that it can be taken out to the byte. The journal of a call that is
 * under way is one, too, with nothing but originals. Paths use '/'.
 */
final class Receipt {
    private static final ObjectMapper MAPPER = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);

    /** Version of the plug-in, null where none is installed. */
    public String version;
    /** SHA-256 of each file that was not there before. */
    public Map<String, String> added = new TreeMap<>();
    /** SHA-256 of each file that was there before, as it was written. */
    public Map<String, String> changed = new TreeMap<>();
    /** The bytes that the changed files had before; in a journal null for a file that was not there. */
    public Map<String, byte[]> originals = new TreeMap<>();
    /** SHA-256 of each jar of MyRobotLab's that made room for one of ours, by its name; it lies in {@code libraries/sear-replaced}. */
    public Map<String, String> replaced = new TreeMap<>();
    /** What earlier versions wrote: folders that were not there before. */
    public Set<String> folders = Set.of();

    /**
     * What a file says, nothing where there is none.
     *
     * @param advice what to do when it can't be read
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
