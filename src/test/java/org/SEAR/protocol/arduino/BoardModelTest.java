// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.arduino;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Pins as printed on the boards. */
public class BoardModelTest {
    @Test
    public void namesOfPins() {
        assertEquals(7, BoardModel.UNO.pinOf("7"));
        assertEquals(7, BoardModel.UNO.pinOf("D7"));
        assertEquals(14, BoardModel.UNO.pinOf("a0"));
        assertEquals(-1, BoardModel.UNO.pinOf("A9"));
        assertEquals(63, BoardModel.MEGA.pinOf("A9"));
        assertEquals(-1, BoardModel.UNO.pinOf("20"));
        assertEquals(-1, BoardModel.UNO.pinOf("seven"));
        assertEquals(-1, BoardModel.UNO.pinOf(null));
        assertEquals("A5", BoardModel.UNO.nameOf(19));
        assertEquals("53", BoardModel.MEGA.nameOf(53));
    }

    @Test
    public void capabilitiesOfPins() {
        assertEquals("3, 5, 6, 9 to 11", BoardModel.UNO.pinsFor(PinUse.PWM));
        assertEquals("2 to 13, A0 to A5", BoardModel.UNO.pinsFor(PinUse.DIGITAL));
        assertEquals("2, 3", BoardModel.UNO.pinsFor(PinUse.INTERRUPT));
        assertEquals("A0 to A15", BoardModel.MEGA.pinsFor(PinUse.ANALOG));
        assertEquals("2 to 13, 44 to 46", BoardModel.MEGA.pinsFor(PinUse.PWM));
        assertEquals("2 to 49", BoardModel.MEGA.pinsFor(PinUse.SERVO));
        assertEquals("none", BoardModel.UNO.pinsFor(PinUse.INTERRUPT, pin -> pin > 3));
        assertFalse(BoardModel.UNO.can(1, PinUse.DIGITAL));
        assertTrue(BoardModel.UNO.can(19, PinUse.I2C));
        assertEquals(20, BoardModel.UNO.getPins());
        assertEquals(70, BoardModel.MEGA.getPins());
    }

    @Test
    public void namesOfBoardsAndRoles() {
        assertEquals(BoardModel.MEGA, BoardModel.of("Mega"));
        assertNull(BoardModel.of("due"));
        assertEquals("uno, mega", BoardModel.words());
        assertEquals(WireRole.ENCODER_A, WireRole.of("encodera"));
        assertNull(WireRole.of("power"));
    }
}
