// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import org.SEAR.files.AtomicFile;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.xml.Xml;

/** The object files of one project, by their paths below its folder. Guarded by the project lock. */
final class ObjectFiles {
    final Path folder;

    ObjectFiles(Path folder) {
        this.folder = folder;
    }

    Path file(String path) {
        return folder.resolve(path);
    }

    /**
     * Reads a file.
     *
     * @return null if it does not exist
     * @throws IOException if it is no ordinary file, or larger than an object's file may be
     */
    byte[] read(String path) throws IOException {
        Path file = file(path);
        if (!Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
            return null;
        }
        if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS) || Files.size(file) > Xml.MAX_BYTES) {
            throw new IOException(file + " is not the file of an object, legal: a file of at most " + Xml.MAX_BYTES
                + " bytes");
        }
        return Files.readAllBytes(file);
    }

    /** Writes a file atomically; null deletes it, and its robot's own folder if that becomes empty. */
    void write(String path, byte[] content) throws IOException {
        Path file = file(path);
        if (content != null) {
            Files.createDirectories(file.getParent());
            AtomicFile.write(file, content);
        } else if (Files.deleteIfExists(file) && path.indexOf('/') != path.lastIndexOf('/')) {
            deleteIfEmpty(file.getParent());
        }
    }

    private static void deleteIfEmpty(Path directory) throws IOException {
        boolean empty;
        try (DirectoryStream<Path> files = Files.newDirectoryStream(directory)) {
            empty = !files.iterator().hasNext();
        }
        if (empty) {
            Files.delete(directory);
        }
    }

    /**
     * Returns the path of an object's file.
     *
     * @param stem as {@code SearObject.getFileName}
     */
    static String path(boolean part, String stem) {
        return (part ? ProjectFolder.ROBOT : ProjectFolder.ENVIRONMENT) + "/" + stem + ProjectFolder.XML;
    }

    /** Returns the path without folder and ending. */
    static String stem(String path) {
        return path.substring(path.indexOf('/') + 1, path.length() - ProjectFolder.XML.length());
    }
}
