// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.ByteArrayInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The pictures and models of a project: files below its {@code assets/} folder, else files that come with SEAR ({@code
 * models/Tree/Tree.mesh.xml}, {@code textures/roomba.jpg} and others), else {@link MadePictures generated pictures}.
 * Immutable, any thread.
 */
public final class Assets {
    /** Class path of the assets that come with SEAR. */
    public static final String SHIPPED = "org/SEAR/assets/";

    private final Path folder;

    /** @param folder the project's own assets; may be missing */
    public Assets(Path folder) {
        this.folder = folder;
    }

    /** Returns the normalised path: {@code ./textures/roomba.jpg} becomes {@code textures/roomba.jpg}. */
    public static String normal(String path) {
        return path.startsWith("./") ? normal(path.substring(2)) : path;
    }

    /** Returns the folder of the project's own assets, which may be missing. */
    public Path getFolder() {
        return folder;
    }

    /**
     * Returns whether the asset exists.
     *
     * @param path as written in an object
     */
    public boolean has(String path) {
        return Files.isRegularFile(folder.resolve(normal(path))) || Assets.class.getClassLoader()
            .getResource(SHIPPED + normal(path)) != null || MadePictures.isThere(normal(path));
    }

    /**
     * Returns the size of an asset, bytes.
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
     * Returns the width and height of a picture, pixels. Throws if it can't be decoded, or needs too much memory.
     *
     * @param path as written in an object
     * @throws UnreadablePicture if it is harmless but can't be shown
     * @throws IOException with the file, the problem and legal values
     */
    public int[] checkPicture(String path) throws IOException {
        try (InputStream in = open(path)) {
            return PictureSize.of(in.readNBytes(FileLimits.MAX_PICTURE + 1), normal(path));
        }
    }

    /**
     * Returns the bytes of a picture that is safe to decode.
     *
     * @param path as written in an object
     * @return the file without data that its pixels don't need
     * @throws UnreadablePicture if it is harmless but can't be shown
     * @throws IOException with the file, the problem and legal values
     */
    public byte[] readPicture(String path) throws IOException {
        try (InputStream in = open(path)) {
            return PictureSize.checked(in.readNBytes(FileLimits.MAX_PICTURE + 1), normal(path));
        }
    }

    /**
     * Opens an asset.
     *
     * @param path as written in an object
     * @throws FileNotFoundException with its expected path
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
            throw new FileNotFoundException("no asset \"" + path + "\": save the file as " + file);
        }
        return shipped;
    }
}
