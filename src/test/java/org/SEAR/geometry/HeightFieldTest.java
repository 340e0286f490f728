package org.SEAR.geometry;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

public class HeightFieldTest {
    private final HeightField field = new HeightField(3, 2, -10, 4, 10, 2, new float[] {0, 1, 4, 8, 2, 2});

    @Test
    public void postsLieRowByRowFromTheSouthWest() {
        assertEquals(8, field.y(1, 1), 0);
        assertEquals(0, field.x(1), 0);
        assertEquals(6, field.z(1), 0);
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 2; column++) {
                assertEquals(field.y(row, column), field.height(field.x(row), field.z(column)), 0);
            }
        }
    }

    @Test
    public void aCellIsTwoPlanesThatMeetFromSouthWestToNorthEast() {
        assertEquals("on the diagonal", 4, field.height(-5, 5), 1e-12);
        assertEquals("east of it", 0.5 + (8 - 1) * 0.25, field.height(-7.5, 5), 1e-12);
        assertEquals("west of it", 4 * 0.75 + (8 - 4) * 0.5, field.height(-2.5, 5), 1e-12);
    }

    @Test
    public void besideTheFieldThereIsNoGround() {
        assertTrue(Double.isNaN(field.height(10.001, 5)));
        assertTrue(Double.isNaN(field.height(0, 3.999)));
        assertTrue(Double.isNaN(field.height(Double.NaN, 5)));
        assertEquals(2, field.height(10, 6), 0);
    }

    @Test
    public void whatIsNoFieldIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new HeightField(2, 2, 0, 0, 1, 1, new float[5]));
        assertThrows(IllegalArgumentException.class, () -> new HeightField(1, 4, 0, 0, 1, 1, new float[4]));
        assertThrows(IllegalArgumentException.class, () -> new HeightField(2, 2, 0, 0, Double.NaN, 1, new float[4]));
    }
}
