// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.Needs;
import org.SEAR.Slow;
import org.SEAR.files.Assets;
import org.SEAR.terrain.format.ElevationMap;
import org.SEAR.terrain.format.ElevationMaps;
import org.junit.BeforeClass;
import org.junit.ClassRule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** Maps that GDAL writes, in many encodings and projections, compared with GDAL's own values. */
@Category(Slow.class)
@Needs("rasterio")
public class RasterioTest {
    private static final int MAPS = 36;
    private static final long SEED = Long.getLong("sear.fuzzSeed", 1);

    @ClassRule
    public static final TemporaryFolder FOLDER = new TemporaryFolder();
    private static Assets assets;

    @BeforeClass
    public static void write() throws IOException, InterruptedException {
        Path script = Paths.get(System.getProperty("sear.root", "."), "src/test/rasterio/make_maps.py");
        File log = FOLDER.newFile("log");
        Process python = new ProcessBuilder("python3", script.toString(),
            System.getProperty("sear.rasterio", "build/rasterio"),
            FOLDER.getRoot().getPath(), Long.toString(SEED)).redirectErrorStream(true).redirectOutput(log).start();
        assertTrue("GDAL takes long", python.waitFor(5, TimeUnit.MINUTES));
        assertEquals(Files.readString(log.toPath(), StandardCharsets.UTF_8), 0, python.exitValue());
        assets = new Assets(FOLDER.getRoot().toPath());
    }

    private static List<String> maps() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER.getRoot().toPath())) {
            List<String> names = files.map(file -> file.getFileName().toString()).filter(ElevationMaps::isMap).sorted()
                .collect(Collectors.toList());
            assertTrue(names.toString(), names.size() >= MAPS);
            return names;
        }
    }

    private static Path beside(String map, String ending) {
        return FOLDER.getRoot().toPath().resolve(map.substring(0, map.lastIndexOf('.')) + ending);
    }

    @Test
    public void eachPostIsTheSameToTheBit() throws IOException {
        for (String name : maps()) {
            try (ElevationMap map = ElevationMaps.open(assets, name)) {
                ByteBuffer wanted = ByteBuffer.wrap(Files.readAllBytes(beside(name, ".posts")));
                float[] read = map.read(0, 0, map.rows, map.columns);
                assertEquals(name, wanted.remaining(), 4 * read.length);
                for (int i = 0; i < read.length; i++) {
                    assertEquals(name + " post " + i, wanted.getFloat(), read[i], 0);
                }
            }
        }
    }

    @Test
    public void aPartIsThatPartOfTheWhole() throws IOException {
        for (String name : maps()) {
            try (ElevationMap map = ElevationMaps.open(assets, name)) {
                float[] all = map.read(0, 0, map.rows, map.columns);
                float[] part = map.read(13, 31, 37, 44);
                for (int i = 0; i < part.length; i++) {
                    assertEquals(name + " post " + i, all[(13 + i / 44) * map.columns + 31 + i % 44], part[i], 0);
                }
            }
        }
    }

    @Test
    public void heightsAtPlacesOnEarthAreTheSame() throws IOException {
        List<String> wrong = new ArrayList<>();
        for (String name : maps()) {
            Ground ground = TerrainLoader.load(TerrainArea.of(name, Collections.emptyList()), assets);
            int seen = 0;
            for (String line : Files.readAllLines(beside(name, ".places"))) {
                String[] words = line.split(" ");
                double height = ground.height(Double.parseDouble(words[0]), Double.parseDouble(words[1]));
                if (!Double.isNaN(height)) {
                    seen++;
                    if (Math.abs(height - Double.parseDouble(words[2])) > 0.01) {
                        wrong.add(name + " at " + line + " is " + height);
                    }
                }
            }
            assertTrue(name + ": " + seen + " places", seen > 8);
        }
        assertEquals(String.join("\n", wrong), 0, wrong.size());
    }
}
