// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * The null-modem cable and the clock. The fastest of several trials counts, because other work on the machine only
 * slows it down.
 */
@Category(Slow.class)
public class SerialClockTest {
    private static final int TRIALS = 5;
    private static final int BYTES = 480;

    private final VirtualSerialPort left = new VirtualSerialPort("/dev/left");
    private final VirtualSerialPort right = new VirtualSerialPort("/dev/right");

    private Collector connect() throws IOException {
        Collector heard = new Collector("heard");
        VirtualSerialPort.makeNullModem(left, right);
        left.open();
        right.open();
        right.listen(heard);
        return heard;
    }

    @After
    public void closePorts() {
        left.close();
        right.close();
    }

    @Test
    public void closingDoesNotWaitForAReaderThatWaitsForThePort() throws Exception {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < TRIALS; i++) {
            connect();
            long start = System.nanoTime();
            right.close();
            least = Math.min(least, seconds(start));
            left.close();
        }
        assertTrue("took " + least + " s", least < 0.5);
    }

    @Test
    public void bytesTakeTheTimeOfTheSlowerEnd() throws Exception {
        double both = transfer(19200, 19200);
        double slower = transfer(19200, 9600);
        assertTrue("took " + slower + " s", slower >= 0.5);
        assertTrue("took " + slower + " s, twice as fast " + both + " s", slower < 3 * both && slower > 1.3 * both);
    }

    private double transfer(int leftRate, int rightRate) throws Exception {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < TRIALS; i++) {
            Collector heard = connect();
            left.setParams(leftRate, 8, 1, 0);
            right.setParams(rightRate, 8, 1, 0);
            long start = System.nanoTime();
            left.write(new byte[BYTES]);
            assertEquals(BYTES, heard.await(BYTES).length);
            least = Math.min(least, seconds(start));
            closePorts();
        }
        return least;
    }

    private static double seconds(long start) {
        return (System.nanoTime() - start) / 1e9;
    }
}
