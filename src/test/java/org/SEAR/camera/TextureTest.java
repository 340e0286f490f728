// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Textures on surfaces: pixel positions, repetition or clamping beyond the edges, and filtering at a distance. */
public class TextureTest {
    private static final double EVEN = 0.51;
    private final SurfaceHit spot = new SurfaceHit();

    /** Returns 2 x 2 pixels: red and green above, blue and white below. */
    private static Texture four(boolean repeated) {
        return new Texture(2, 2, new int[] {0xff0000, 0x00ff00, 0x0000ff, 0xffffff}, repeated);
    }

    private void assertSeen(String what, int rgb, double off) {
        assertEquals(what + " red", rgb >> 16, spot.red, off);
        assertEquals(what + " green", rgb >> 8 & 0xff, spot.green, off);
        assertEquals(what + " blue", rgb & 0xff, spot.blue, off);
    }

    private void look(Texture texture, double u, double v, double pixel) {
        texture.look(u, v, pixel, 0, 0, pixel, spot);
    }

    @Test
    public void coordinatesCountFromTheLowerLeft() {
        look(four(true), 0.25, 0.75, 0.01);
        assertSeen("upper left", 0xff0000, EVEN);
        look(four(true), 0.75, 0.75, 0.01);
        assertSeen("upper right", 0x00ff00, EVEN);
        look(four(true), 0.25, 0.25, 0.01);
        assertSeen("lower left", 0x0000ff, EVEN);
        look(four(true), 0.5, 0.75, 0.01);
        assertSeen("between two", 0x808000, 1);
    }

    @Test
    public void beyondItsEdgesItRepeatsOrClamps() {
        look(four(true), 5.25, -2.25, 0.01);
        assertSeen("repeated", 0xff0000, EVEN);
        look(four(true), 0, 0.75, 0.01);
        assertSeen("half of the other edge", 0x808000, 1);
        look(four(false), -3, 7, 0.01);
        assertSeen("its edge", 0xff0000, EVEN);
    }

    @Test
    public void aDistantPatternHasItsMeanColour() {
        int[] pixels = new int[64 * 64];
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = (i % 64 + i / 64) % 2 == 0 ? 0xffffff : 0;
        }
        Texture chess = new Texture(64, 64, pixels, true);
        for (int i = 0; i < 50; i++) {
            look(chess, 0.013 * i, 0.029 * i, 0.2);
            assertSeen("at " + i, 0x808080, 1);
        }
    }

    @Test
    public void atAFlatAngleStripesAlongTheViewStaySharp() {
        int[] pixels = new int[64 * 64];
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = i % 64 / 8 % 2 == 0 ? 0xffffff : 0;
        }
        Texture stripes = new Texture(64, 64, pixels, true);
        double pixel = 1 / 64.0;
        stripes.look(4 * pixel, 0.5, pixel, 0, 0, 8 * pixel, spot);
        assertTrue("white: " + spot.red, spot.red > 240);
        stripes.look(12 * pixel, 0.5, pixel, 0, 0, 8 * pixel, spot);
        assertTrue("black: " + spot.red, spot.red < 15);
        stripes.look(4 * pixel, 0.5, 32 * pixel, 0, 0, 32 * pixel, spot);
        assertTrue("far away from all sides it is grey: " + spot.red, spot.red > 60 && spot.red < 200);
    }
}
