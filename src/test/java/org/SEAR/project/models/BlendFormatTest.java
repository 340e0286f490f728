// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;

import java.util.Arrays;
import org.junit.Rule;
import org.junit.Test;

/** Features of Blender files, by bounding box, area and volume; Blender's z is up, its y is -z here. */
public class BlendFormatTest {
    private static final float[] CUBE = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    private static final int[][] SIDES = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0,
        4, 7}};

    @Rule
    public final FormatRule project = new FormatRule();

    private Measures load(byte[] file) throws Exception {
        return project.with("m.blend", file).load("m.blend");
    }

    @Test
    public void aCubeIsACube() throws Exception {
        load(BlendFile.mesh(CUBE, SIDES, new float[] {5, 0, 0})).hasBox(5, 0, -1, 6, 1, 0).hasArea(6).hasVolume(1);
    }

    @Test
    public void aChildTurnedInAScaledParentShears() throws Exception {
        double root = Math.sqrt(2);
        load(BlendFile.sheared(CUBE, SIDES)).hasBox(-root, 0, -root, root, 1, 0).hasVolume(2).hasArea(4
            + 4 * Math.sqrt(2.5));
    }

    @Test
    public void concaveFacesAreFilledExactly() throws Exception {
        float[] dart = {0, 0, 0, 2, 0, 1, 0, 0, 2, 1, 0, 1};
        float[] comb = {0, 0, 0, 9, 0, 0, 9, 0, 3, 8, 0, 1, 5, 0, 3, 3, 0, 1, 0, 0, 3};
        for (int first = 0; first < 7; first++) {
            int[] corners = new int[4];
            int[] many = new int[7];
            for (int i = 0; i < 7; i++) {
                corners[i % 4] = (i + first) % 4;
                many[i] = (i + first) % 7;
            }
            load(BlendFile.mesh(dart, new int[][] {corners}, new float[3])).hasArea(1).hasTriangles(2);
            load(BlendFile.mesh(comb, new int[][] {many}, new float[3])).hasArea(18).hasTriangles(5);
        }
    }

    @Test
    public void modifiersApplyUpToALimit() throws Exception {
        load(BlendFile.modified(CUBE, SIDES, "Subsurf", 2)).hasTriangles(192).hasArea(6).hasVolume(1);
        load(BlendFile.modified(CUBE, SIDES, "Array", 3)).hasBox(0, 0, -1, 3, 1, 0).hasArea(18);
        assertEquals(Arrays.asList(), project.warnings);
        project.with("m.blend", BlendFile.modified(CUBE, SIDES, "Subsurf", 9)).refuses("m.blend",
            "m.blend: the number of faces after the Subsurf modifier of the object solid is 1572864, legal: at "
            + "most 250000");
        project.with("m.blend", BlendFile.modified(CUBE, SIDES, "Subsurf", 7)).refuses("m.blend",
            "m.blend: the number of faces of subdivided objects, up to the Subsurf modifier of the object solid, is "
            + "98304, legal: at most 25000: lower its levels or count, apply it in Blender, or export .glb");
        project.with("m.blend", BlendFile.modified(CUBE, SIDES, "Array", 1_000_000)).refuses("m.blend",
            "modifier of the object solid is 6000000");
        project.with("m.blend", BlendFile.modified(CUBE, SIDES, "Array", 3000)).refuses("m.blend",
            "m.blend: the product of faces and copies, up to the Array modifier of the object solid, is 54000000, "
                + "legal: at most 30000000: lower");
        load(BlendFile.modified(CUBE, SIDES, "Bevel", 0)).hasVolume(1);
        assertEquals(Arrays.asList("model m.blend: the Bevel modifier of the object solid is left out: apply it in "
            + "Blender, or export .glb"),
            project.warnings);
    }

    @Test
    public void errorsNameTheBlockAndTheValue() throws Exception {
        byte[] good = BlendFile.mesh(CUBE, SIDES, new float[3]);
        byte[] head = good.clone();
        head[8] = 'x';
        project.with("m.blend", head).refuses("m.blend",
            "m.blend: the head is BLENDER-x279, legal: BLENDER-v and three digits");
        byte[] size = good.clone();
        size[19] = 1;
        project.with("m.blend", size).refuses("m.blend", "m.blend: the size of block 0 (DATA) at byte 12 is 16777");
        project.with("m.blend", Arrays.copyOf(good, good.length - 30)).refuses("m.blend", "block");
        byte[] zstandard = {0x28, (byte) 0xb5, 0x2f, (byte) 0xfd, 0, 1, 2, 3, 4, 5, 6, 7, 8};
        project.with("m.blend", zstandard).refuses("m.blend", "m.blend: the head is (\u00b5/\u00fd?");
    }
}
