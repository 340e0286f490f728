// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.Terrain;
import org.SEAR.files.Assets;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.terrain.Ground;
import org.SEAR.terrain.MapCut;
import org.SEAR.terrain.TerrainArea;
import org.SEAR.terrain.TerrainColors;
import org.SEAR.terrain.TerrainLoader;
import org.SEAR.terrain.format.ElevationMaps;

/** The ground of a project's terrain, loaded on first use and kept with the project. Any thread. */
final class TerrainGround {
    private static final String USABLE = "an elevation map that can be used (";

    private final ParsedObject parsed;
    private final Assets assets;
    private Ground ground;

    /** @param parsed a terrain */
    TerrainGround(ParsedObject parsed, Assets assets) {
        this.parsed = parsed;
        this.assets = assets;
    }

    /**
     * Loads the ground of a terrain.
     *
     * @throws IOException that names the map, its problem and what is legal
     */
    static Ground load(Terrain terrain, Assets assets) throws IOException {
        return TerrainLoader.load(area(terrain), assets);
    }

    private static TerrainArea area(Terrain terrain) {
        TerrainArea area = TerrainArea.of(terrain.getPath(), terrain.getPaths().subList(1, terrain.getPaths().size()));
        if (terrain.hasArea()) {
            area = area.around(terrain.getLatitude(), terrain.getLongitude(), terrain.getNorthSouth(),
                terrain.getEastWest());
        }
        if (terrain.hasSize()) {
            area = area.sized(terrain.getNorthSouth(), terrain.getEastWest(), terrain.getLowest(),
                terrain.getHighest());
        }
        return area;
    }

    /** @throws ProjectException if a map can't be read */
    synchronized Ground get() throws ProjectException {
        if (ground == null) {
            Terrain terrain = (Terrain) parsed.object;
            try {
                ground = load(terrain, assets);
            } catch (IOException e) {
                throw problem(terrain, e);
            }
        }
        return ground;
    }

    /** Returns the problems of maps with an unusable header; the data behind the headers is not read. */
    List<Problem> brokenMaps() {
        List<Problem> broken = new ArrayList<>();
        List<String> paths = ((Terrain) parsed.object).getPaths();
        for (int i = 0; i < paths.size(); i++) {
            try {
                ElevationMaps.check(assets, paths.get(i));
            } catch (IOException e) {
                broken.add(new Problem(parsed.file, parsed.line(i == 0 ? "path" : "tile#" + (i - 1)), i == 0 ? "path"
                    : "tile", paths.get(i), USABLE + e.getMessage() + ")"));
            }
        }
        return broken;
    }

    /** @throws ProjectException if a GeoTIFF on the ground can't be shown */
    void checkPicture() throws ProjectException {
        Terrain terrain = (Terrain) parsed.object;
        try {
            TerrainColors.check(terrain, assets, get());
        } catch (IOException e) {
            throw new ProjectException(Collections.singletonList(
                new Problem(parsed.file, parsed.line("image"), "image", terrain.getImage(),
                "a picture that can be shown (" + e.getMessage() + ")")));
        }
    }

    /**
     * Returns the used part of the maps as one file.
     *
     * @return null if the maps are used completely, or if the file can't be written
     * @throws ProjectException if a map can't be read
     */
    byte[] cut() throws ProjectException {
        Terrain terrain = (Terrain) parsed.object;
        try {
            return MapCut.of(area(terrain), assets);
        } catch (IOException e) {
            throw problem(terrain, e);
        }
    }

    private ProjectException problem(Terrain terrain, IOException e) {
        return new ProjectException(Collections.singletonList(
            new Problem(parsed.file, parsed.line("path"), "path", terrain.getPath(), USABLE + e.getMessage() + ")")));
    }
}
