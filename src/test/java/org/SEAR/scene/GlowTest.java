// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** Colours of a light, off and on. */
public class GlowTest {
    @Test
    public void aDarkLightHasAFifthOfItsColourAndALitOneAllOfIt() {
        assertEquals("#331a00", Glow.of("#ff8000", 0));
        assertEquals("#ff8000", Glow.of("#ff8000", 1));
        assertEquals("#994d00", Glow.of("#ff8000", 0.5));
        assertEquals("#000000", Glow.of("#000000", 1));
    }
}
