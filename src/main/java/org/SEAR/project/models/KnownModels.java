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
 * The triangles of the models of one project, the last, kept while memory lasts: who loads a project looks at its models, and the start needs them.
 * As soon as any file of the assets is another they are loaded anew, since a model may be of several files. Any thread.
 */
final class KnownModels {
    private static SoftReference<KnownModels> last = new SoftReference<>(null);

    private final String files;
    private final Map<String, Known> models = new ConcurrentHashMap<>();

    private KnownModels(String files) {
        this.files = files;
    }

    /** Those of a project, as its files are now. */
    static synchronized KnownModels of(Assets assets) {
        String files;
        try {
            files = files(assets.getFolder());
        } catch (IOException | UncheckedIOException e) {
            return new KnownModels("");         // who can't look at all files does not know whether they are others: it is of no use to the next
        }
        KnownModels known = last.get();
        if (known == null || !known.files.equals(files)) {
            known = new KnownModels(files);
            last = new SoftReference<>(known);
        }
        return known;
    }

    /** Without the folder's own name: a project that was found valid is renamed. */
    private static String files(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            return "";
        }
        try (Stream<Path> all = Files.walk(folder, FileVisitOption.FOLLOW_LINKS)) {
            StringBuilder text = new StringBuilder();
            for (Path file : all.collect(Collectors.toCollection(TreeSet::new))) {
                BasicFileAttributes is = Files.readAttributes(file, BasicFileAttributes.class);
                text.append(folder.relativize(file) + " " + is.size() + " " + is.lastModifiedTime().toInstant() + " " + is.fileKey() + "\n");
            }
            return text.toString();
        }
    }

    /** What a model's triangles depend on beside those files: some file systems have times of two seconds, so its bytes count, too. */
    static String key(Model model, Assets assets) throws IOException {
        CRC32 sum = new CRC32();
        try (InputStream in = assets.open(model.getPath())) {
            in.transferTo(new CheckedOutputStream(OutputStream.nullOutputStream(), sum));
        }
        return model.getPath() + " " + sum.getValue() + " " + model.isTerrain();
    }

    /** Null if it isn't known. */
    Known get(String key) {
        return models.get(key);
    }

    void put(String key, Known model) {
        models.put(key, model);
    }

    /** A model that was loaded. */
    static final class Known {
        final Triangles triangles;
        /** What of it can't be shown. */
        final List<String> leftOut;

        Known(Triangles triangles, List<String> leftOut) {
            this.triangles = triangles;
            this.leftOut = leftOut;
        }
    }
}
