package org.SEAR.terrain;

import java.io.IOException;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.SEAR.files.Assets;

/**
 * Loads the ground of a world. Who asks again for the same area of the same files while anybody uses it gets the same object: simulator, window, tab
 * and scripts share one array of heights. Any thread; one loads at a time.
 */
public final class TerrainLoader {
    private static final Map<String, WeakReference<Ground>> LOADED = new HashMap<>();

    private TerrainLoader() {
    }

    /**
     * Loads maps, or returns what is loaded of them.
     *
     * @param area which maps and which part of them
     * @throws IOException that names the file, what is wrong in it and what is legal
     */
    public static Ground load(TerrainArea area, Assets assets) throws IOException {
        synchronized (LOADED) {
            LOADED.values().removeIf(reference -> reference.get() == null);
            String key = key(area, assets);
            WeakReference<Ground> loaded = LOADED.get(key);
            Ground ground = loaded == null ? null : loaded.get();
            if (ground == null) {
                ground = read(area, assets);
                LOADED.put(key, new WeakReference<>(ground));
            }
            return ground;
        }
    }

    private static Ground read(TerrainArea area, Assets assets) throws IOException {
        try (Mosaic mosaic = Mosaic.open(assets, area.paths)) {
            return new GroundBuilder(mosaic, area).build();
        }
    }

    /** What the ground depends on: another file of the same name has another size or time. */
    private static String key(TerrainArea area, Assets assets) throws IOException {
        StringBuilder key = new StringBuilder(area.toString());
        for (String path : area.paths) {
            Path file = assets.getFolder().resolve(path);
            if (Files.isRegularFile(file)) {
                key.append("|" + file.toAbsolutePath() + " " + Files.size(file) + " " + Files.getLastModifiedTime(file));
            }
        }
        return key.toString();
    }
}
