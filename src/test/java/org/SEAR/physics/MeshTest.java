// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.junit.Test;

/** A mesh is as smooth as its faces: inner edges neither stop nor turn a body. */
public class MeshTest {
    private final Findings findings = new Findings();

    @Test
    public void bodiesDoNotStumbleOverInnerEdges() throws Exception {
        for (int cells : new int[] {2, 25, 60}) {
            MeshScenes.over(true, cells, findings);
            MeshScenes.over(false, cells, findings);
        }
        findings.assertHold();
    }

    @Test
    public void aBallRollsUpWhereTheGroundRises() throws Exception {
        for (int cells : new int[] {2, 25, 60}) {
            MeshScenes.up(10, 2, cells, findings);
            MeshScenes.up(30, 3, cells, findings);
        }
        findings.assertHold();
    }
}
