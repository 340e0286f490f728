// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** A byte takes ten bits on the line. */
public class UartTest {
    @Test
    public void aByteTakesStartBitDataAndStopBit() {
        assertEquals(732 * 10 / 38400.0, Uart.seconds(732, 38400), 0);
        assertEquals("a frame of the Open Interface every 15 ms", 86.4, Uart.bytes(0.015, 57600), 1e-9);
    }
}
