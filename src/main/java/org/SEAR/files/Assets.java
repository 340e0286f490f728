package org.SEAR.files;

import java.io.ByteArrayInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The pictures and models of a project: files below its {@code assets/} folder, and for paths that it doesn't have, those that come with SEAR
 * ({@code models/Tree/Tree.mesh.xml}, {@code textures/roomba.jpg} and others), or pictures that are {@link MadePictures made}. Immutable, any thread.
 */
public final class Assets {
    /** Where the assets that come with SEAR lie on the class path. */
    public static final String SHIPPED = "org/SEAR/assets/";

    private final Path folder;

    /** @param folder the project's own assets; it may not exist */
    public Assets(Path folder) {
        this.folder = folder;
    }

    /** The path as it is looked up: {@code ./textures/roomba.jpg} becomes {@code textures/roomba.jpg}. */
    public static String normal(String path) {
        return path.startsWith("./") ? normal(path.substring(2)) : path;
    }

    /** The folder of the project's own assets; it may not exist. */
    public Path getFolder() {
        return folder;
    }

    /**
     * Whether there is such an asset.
     *
     * @param path as written in an object
     */
    public boolean has(String path) {
        return Files.isRegularFile(folder.resolve(normal(path))) || Assets.class.getClassLoader().getResource(SHIPPED + normal(path)) != null
            || MadePictures.isThere(normal(path));
    }

    /**
     * Bytes of an asset.
     *
     * @param path as written in an object
     * @throws FileNotFoundException if there is none
     */
    public long size(String path) throws IOException {
        Path file = folder.resolve(normal(path));
        if (Files.isRegularFile(file)) {
            return Files.size(file);
        }
        try (InputStream in = open(path)) {
            return in.available();
        }
    }

    /**
     * Refuses a picture that can't be unpacked, or takes too much memory then.
     *
     * @param path as written in an object
     * @throws UnreadablePicture if it does no harm but can't be shown
     * @throws IOException that names the file, what is wrong and what is legal
     */
    public void checkPicture(String path) throws IOException {
        readPicture(path);
    }

    /**
     * The bytes of a picture that can be unpacked without harm.
     *
     * @param path as written in an object
     * @return without what doesn't belong to its pixels
     * @throws UnreadablePicture if it does no harm but can't be shown
     * @throws IOException that names the file, what is wrong and what is legal
     */
    public byte[] readPicture(String path) throws IOException {
        try (InputStream in = open(path)) {
            return PictureSize.checked(in.readNBytes(FileLimits.MAX_PICTURE + 1), normal(path));
        }
    }

    /**
     * The bytes of an asset.
     *
     * @param path as written in an object
     * @throws FileNotFoundException that says where it should be
     */
    public InputStream open(String path) throws IOException {
        Path file = folder.resolve(normal(path));
        if (Files.isRegularFile(file)) {
            return Files.newInputStream(file);
        }
        InputStream shipped = Assets.class.getClassLoader().getResourceAsStream(SHIPPED + normal(path));
        if (shipped == null && MadePictures.isThere(normal(path))) {
            return new ByteArrayInputStream(MadePictures.of(normal(path)));
        }
        if (shipped == null) {
            throw new FileNotFoundException("no asset \"" + path + "\": put the file to " + file);
        }
        return shipped;
    }
}
