// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.junit.Test;

/** Rows of thirty dominoes in twenty spacings and sizes. */
public class DominoesTest {
    private final Findings findings = new Findings();

    @Test
    public void everyRowFallsToTheLast() throws Exception {
        for (double height : DominoScenes.HEIGHTS) {
            for (double gap : DominoScenes.GAPS) {
                DominoScenes.row(height, gap, findings);
            }
        }
        findings.assertHold();
    }
}
