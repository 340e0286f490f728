// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.lang.ref.SoftReference;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import java.util.zip.CheckedOutputStream;
import org.SEAR.POJOs.Model;
import org.SEAR.files.Assets;
import org.SEAR.geometry.Triangles;

/**
 * Soft-referenced cache of the triangles of the last project's models, which both loading and starting need. A change
 * of any file in the assets clears it, since a model may consist of several files. Any thread.
 */
final class KnownModels {
    private static SoftReference<KnownModels> last = new SoftReference<>(null);

    private final String files;
    private final Map<String, Known> models = new ConcurrentHashMap<>();

    private KnownModels(String files) {
        this.files = files;
    }

    /** Returns the cache of a project's current files. */
    static synchronized KnownModels of(Assets assets) {
        String files;
        try {
            files = files(assets.getFolder());
        } catch (IOException | UncheckedIOException e) {
            // without a list of all files a change can't be detected, so the cache is not shared
            return new KnownModels("");
        }
        KnownModels known = last.get();
        if (known == null || !known.files.equals(files)) {
            known = new KnownModels(files);
            last = new SoftReference<>(known);
        }
        return known;
    }

    /**
     * Returns a text that changes with any file. It does not contain the folder's name, since a project is renamed
     * after validation.
     */
    private static String files(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            return "";
        }
        try (Stream<Path> all = Files.walk(folder, FileVisitOption.FOLLOW_LINKS)) {
            StringBuilder text = new StringBuilder();
            for (Path file : all.collect(Collectors.toCollection(TreeSet::new))) {
                BasicFileAttributes is = Files.readAttributes(file, BasicFileAttributes.class);
                text.append(folder.relativize(file) + " " + is.size() + " " + is.lastModifiedTime().toInstant() + " "
                    + is.fileKey() + "\n");
            }
            return text.toString();
        }
    }

    /**
     * Returns the cache key of a model. It contains a checksum, since some file systems have a time resolution of two
     * seconds.
     */
    static String key(Model model, Assets assets) throws IOException {
        CRC32 sum = new CRC32();
        try (InputStream in = assets.open(model.getPath())) {
            in.transferTo(new CheckedOutputStream(OutputStream.nullOutputStream(), sum));
        }
        return model.getPath() + " " + sum.getValue() + " " + model.isTerrain();
    }

    /** Returns a model; null if it is not in the cache. */
    Known get(String key) {
        return models.get(key);
    }

    void put(String key, Known model) {
        models.put(key, model);
    }

    /** A loaded model. */
    static final class Known {
        final Triangles triangles;
        /** Warnings about parts that can't be shown. */
        final List<String> leftOut;

        Known(Triangles triangles, List<String> leftOut) {
            this.triangles = triangles;
            this.leftOut = leftOut;
        }
    }
}
