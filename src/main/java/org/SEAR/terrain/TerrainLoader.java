// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.IOException;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.SEAR.files.Assets;

/**
 * Loads the ground of a world. Repeated requests for the same area of the same files return the same object while it is
 * in use: simulator, window, tab and scripts share one array. Any thread; loads run one at a time.
 */
public final class TerrainLoader {
    private static final Map<String, WeakReference<Ground>> LOADED = new HashMap<>();

    private TerrainLoader() {
    }

    /**
     * Loads a ground or returns the loaded one.
     * @param area maps and area
     * @throws IOException that names the file, the error and what is legal
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

    /** Returns a key of everything the ground depends on, including size and time of the files. */
    private static String key(TerrainArea area, Assets assets) throws IOException {
        StringBuilder key = new StringBuilder(area.toString());
        for (String path : area.paths) {
            Path file = assets.getFolder().resolve(path);
            if (Files.isRegularFile(file)) {
                key.append("|" + file.toAbsolutePath() + " " + Files.size(file) + " "
                    + Files.getLastModifiedTime(file));
            }
        }
        return key.toString();
    }
}
