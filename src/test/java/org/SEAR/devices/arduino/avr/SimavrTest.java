// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.zip.CRC32;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.ProgramFile;
import org.junit.Test;

/**
 * Outputs of a sketch that calculates without interrupts, compared with simavr 1.6 to the cycle. {@code exact.ino} uses
 * all groups of instructions: floating point, division, 64 bits, tables in the flash, calls and the stack. The numbers
 * here were computed from the output of {@code waves.c}, a program with simavr's library.
 */
public class SimavrTest {
    private static final int CYCLES = 16_000_000;
    private static final int CHANGES = 65744;
    private static final long CHECKSUM = 0xb4189ed0L;

    /** A change of an output. */
    private static final class Change {
        final long cycle;
        final String text;

        Change(long cycle, String text) {
            this.cycle = cycle;
            this.text = text;
        }
    }

    private static final class Recorder implements Surroundings {
        final List<Change> changes = new ArrayList<>();
        private final boolean[] high = new boolean[24];

        @Override
        public void output(int port, int bit, Drive drive, long cycle) {
            boolean now = drive == Drive.HIGH;
            if (now != high[port * 8 + bit]) {
                high[port * 8 + bit] = now;
                changes.add(new Change(cycle, "BCD".charAt(port) + "" + bit + " " + (now ? 1 : 0)));
            }
        }

        @Override
        public double volts(int channel, long cycle) {
            return 0;
        }

        @Override
        public void transmit(int usart, int value, long cycle, int cycles) {
            throw new AssertionError("the sketch sends nothing");
        }

        @Override
        public void report(String message) {
            throw new AssertionError(message);
        }
    }

    @Test
    public void outputsChangeAtTheCyclesOfSimavr() throws IOException {
        Recorder recorder = new Recorder();
        try (InputStream in = SimavrTest.class.getResourceAsStream("exact.hex")) {
            new Atmega328p(ProgramFile.read(in.readAllBytes(), BoardModel.UNO.getFlash()), recorder)
                .run(CYCLES + 100_000);
        }
        long first = recorder.changes.get(0).cycle;
        List<String> lines = recorder.changes.stream().filter(each -> each.cycle < first + CYCLES)
            .sorted(Comparator.comparingLong((Change each) -> each.cycle).thenComparing(each -> each.text))
            .map(each -> each.cycle - first + " " + each.text + "\n").collect(Collectors.toList());
        CRC32 sum = new CRC32();
        lines.forEach(line -> sum.update(line.getBytes(StandardCharsets.US_ASCII)));
        assertEquals(CHANGES, lines.size());
        assertEquals(Long.toHexString(CHECKSUM), Long.toHexString(sum.getValue()));
    }
}
