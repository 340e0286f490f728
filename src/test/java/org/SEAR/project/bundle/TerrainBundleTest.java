// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.SEAR.POJOs.Terrain;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.terrain.Ground;
import org.junit.Rule;
import org.junit.Test;

/** Elevation maps in bundles: whole, or cut to the used area. */
public class TerrainBundleTest {
    private static final String MAP = "maps/jacksboro.tif";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Path own(String path, byte[] bytes) throws Exception {
        Path file = project.folder().resolve("assets").resolve(path);
        Files.createDirectories(file.getParent());
        return Files.write(file, bytes);
    }

    private static byte[] jacksboro() throws Exception {
        try (InputStream in = TerrainBundleTest.class.getResourceAsStream("/org/SEAR/assets/terrain/jacksboro.tif")) {
            return in.readAllBytes();
        }
    }

    private Path bundle() {
        return project.getRoot().toPath().resolve("mountain.sear");
    }

    private Project loaded() throws Exception {
        return Bundle.load(bundle(), project.getRoot().toPath().resolve("other").resolve("SEARproject"));
    }

    @Test
    public void wholeMapsComeAlong() throws Exception {
        byte[] map = jacksboro();
        own(MAP, map);
        new Terrain("jacksboro", MAP).setArea(36.485, -84.2308, 2000, 2000);
        Bundle.save(project.folder(), bundle());
        assertArrayEquals(map, Files.readAllBytes(loaded().asset(MAP)));
    }

    @Test
    public void aCutMapGivesTheSameGroundAndTheProjectStaysAsItIs() throws Exception {
        own(MAP, jacksboro());
        own("maps/again.tif", jacksboro());
        Terrain terrain = new Terrain("jacksboro", MAP);
        terrain.setArea(36.485, -84.2308, 2000, 3000);
        terrain.addTile("maps/again.tif");
        Map<String, String> before = project.files();
        assertTrue(Bundle.saveCut(project.folder(), bundle(), Progress.NONE));
        assertEquals(before, project.files());
        assertTrue(Files.size(bundle()) + " bytes", Files.size(bundle()) < 10_000);
        Project cut = loaded();
        assertFalse(Files.exists(cut.asset(MAP)));
        assertFalse(Files.exists(cut.asset("maps/again.tif")));
        assertEquals("[terrain/jacksboro-area.tif]", ((Terrain) cut.getEnvironment().get(0)).getPaths().toString());
        Ground whole = Project.read(project.folder()).getGround();
        Ground part = cut.getGround();
        assertEquals(whole.field.rows, part.field.rows);
        assertEquals(whole.field.columns, part.field.columns);
        assertEquals(whole.field.lowX, part.field.lowX, 1e-4);
        assertEquals(whole.field.lowZ, part.field.lowZ, 1e-4);
        assertEquals(whole.origin.toString(), part.origin.toString());
        assertArrayEquals(whole.field.heights, part.field.heights, 1e-3f);
        assertEquals(whole.height(36.486, -84.24), part.height(36.486, -84.24), 1e-4);
    }

    @Test
    public void aCutMapCanBeCutAgain() throws Exception {
        own("terrain/jacksboro-area.tif", jacksboro());
        new Terrain("jacksboro", "terrain/jacksboro-area.tif").setArea(36.485, -84.2308, 2000, 3000);
        assertTrue(Bundle.saveCut(project.folder(), bundle(), Progress.NONE));
        Project cut = loaded();
        assertEquals(Project.read(project.folder()).getGround().field.rows, cut.getGround().field.rows);
        assertEquals(1, Files.list(cut.asset("terrain")).count());
    }

    @Test
    public void withoutAnAreaNothingIsCut() throws Exception {
        own(MAP, jacksboro());
        new Terrain("jacksboro", MAP);
        assertFalse(Bundle.saveCut(project.folder(), bundle(), Progress.NONE));
        assertTrue(Files.exists(loaded().asset(MAP)));
    }

    @Test
    public void aPictureOfTheSameNameStays() throws Exception {
        own(MAP, jacksboro());
        Terrain terrain = new Terrain("jacksboro", MAP);
        terrain.setArea(36.485, -84.2308, 2000, 3000);
        terrain.setImage(MAP);
        assertTrue(Bundle.saveCut(project.folder(), bundle(), Progress.NONE));
        assertTrue(Files.exists(loaded().asset(MAP)));
    }

    @Test
    public void zippedTilesComeAlongOtherArchivesDoNot() throws Exception {
        Path zip = own("maps/N36W085.hgt.zip", new byte[0]);
        try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(zip))) {
            out.putNextEntry(new ZipEntry("N36W085.hgt"));
            byte[] tile = new byte[2 * 1201 * 1201];
            Arrays.fill(tile, (byte) 1);
            out.write(tile);
        }
        new Terrain("tile", "maps/N36W085.hgt.zip").setArea(36.485, -84.2308, 2000, 3000);
        Bundle.save(project.folder(), bundle());
        assertEquals("everywhere 257 m", 257, loaded().getGround().height(36.486, -84.23), 1e-6);
        own("maps/maps.zip", Files.readAllBytes(zip));
        String told = assertThrows(ProjectException.class, () -> Bundle.save(project.folder(), bundle())).getMessage();
        assertTrue(told, told.contains("entry is \"assets/maps/maps.zip\", legal: no archive inside a "
            + "bundle; this is zip"));
    }

    @Test
    public void aBundleWithABrokenMapIsRejectedAsAWhole() throws Exception {
        own(MAP, Arrays.copyOf(jacksboro(), 60_000));
        new Terrain("jacksboro", MAP).setArea(36.485, -84.2308, 2000, 3000);
        Bundle.save(project.folder(), bundle());
        String told = assertThrows(ProjectException.class, () -> Bundle.check(bundle(), Progress.NONE, read -> {
            read.getGround();
            return read.getWarnings();
        })).getMessage();
        assertTrue(told, told.contains("environment/jacksboro.xml:15: path is \"maps/jacksboro.tif\", legal: an "
            + "elevation map that can be used ("));
        assertThrows(ProjectException.class, () -> Bundle.saveCut(project.folder(), bundle(), Progress.NONE));
    }
}
