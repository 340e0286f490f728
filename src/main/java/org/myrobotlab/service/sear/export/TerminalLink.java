package org.myrobotlab.service.sear.export;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.regex.Pattern;

/**
 * A symbolic link to a pseudo-terminal. Replaces only an old link to a pseudo-terminal, never another file. Any thread.
 */
final class TerminalLink {
    /** Paths of pseudo-terminals on Linux and macOS. */
    private static final Pattern TERMINAL = Pattern.compile("/dev/pts/\\d+|/dev/ttys\\d+");

    private final Path path;
    private final Path target;

    private TerminalLink(Path path, Path target) {
        this.path = path;
        this.target = target;
    }

    /**
     * Creates a link.
     *
     * @param terminal path of the pseudo-terminal
     * @throws IOException if another file has the name, or the folder is missing
     */
    static TerminalLink make(Path link, String terminal) throws IOException {
        Path made = link.toAbsolutePath();
        Path target = Paths.get(terminal);
        if (isToTerminal(made)) {
            Files.delete(made);
        }
        try {
            Files.createSymbolicLink(made, target);
        } catch (FileAlreadyExistsException e) {
            throw new IOException(made + " exists and is not a link to a pseudo-terminal: choose another name, or remove it", e);
        }
        return new TerminalLink(made, target);
    }

    private static boolean isToTerminal(Path link) throws IOException {
        return Files.isSymbolicLink(link) && TERMINAL.matcher(Files.readSymbolicLink(link).toString()).matches();
    }

    /** Deletes the link unless its target has changed. */
    void remove() throws IOException {
        if (Files.exists(path, LinkOption.NOFOLLOW_LINKS) && Files.isSymbolicLink(path) && Files.readSymbolicLink(path).equals(target)) {
            Files.delete(path);
        }
    }

    @Override
    public String toString() {
        return path.toString();
    }
}
