// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.regex.Pattern;
import org.myrobotlab.service.sear.ExitTasks;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A symbolic link to a pseudo-terminal. Replaces only an old link to a pseudo-terminal, never another file. Deleted at
 * the end of the process at the latest. Any thread.
 */
final class TerminalLink {
    private static final Logger LOG = LoggerFactory.getLogger(TerminalLink.class);
    /** Paths of pseudo-terminals on Linux and macOS. */
    private static final Pattern TERMINAL = Pattern.compile("/dev/pts/\\d+|/dev/ttys\\d+");

    private final Path path;
    private final Path target;
    private final Runnable exitTask = this::removeOrWarn;

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
            throw new IOException(made + " exists and is not a link to a pseudo-terminal: choose another name, "
                + "or remove it", e);
        }
        TerminalLink created = new TerminalLink(made, target);
        ExitTasks.add(created.exitTask);
        return created;
    }

    private static boolean isToTerminal(Path link) throws IOException {
        return Files.isSymbolicLink(link) && TERMINAL.matcher(Files.readSymbolicLink(link).toString()).matches();
    }

    /** Deletes the link unless its target has changed. */
    void remove() throws IOException {
        ExitTasks.remove(exitTask);
        if (Files.exists(path, LinkOption.NOFOLLOW_LINKS) && Files.isSymbolicLink(path) && Files.readSymbolicLink(path)
            .equals(target)) {
            Files.delete(path);
        }
    }

    private void removeOrWarn() {
        try {
            remove();
        } catch (IOException e) {
            LOG.warn("link {} was not removed: {}", path, e.toString());
        }
    }

    @Override
    public String toString() {
        return path.toString();
    }
}
