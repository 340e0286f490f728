// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.protocol.arduino.ProgramFile;
import org.junit.Test;

/** A compiled sketch on the simulated chip, and files that are no programs. */
public class SketchTest {
    private final StringBuilder text = new StringBuilder();
    private final List<String> reports = new ArrayList<>();
    private final List<Long> rises = new ArrayList<>();
    private final List<Long> falls = new ArrayList<>();

    private static byte[] hex(String name) throws IOException {
        try (InputStream in = SketchTest.class.getResourceAsStream(name)) {
            return in.readAllBytes();
        }
    }

    private Atmega328p chip(byte[] program) {
        return new Atmega328p(program, new Surroundings() {
            @Override
            public void output(int port, int bit, Drive drive, long cycle) {
                if (port == 0 && bit == 1) {
                    (drive == Drive.HIGH ? rises : falls).add(cycle);
                }
            }

            @Override
            public double volts(int channel, long cycle) {
                return 2.5;
            }

            @Override
            public void transmit(int usart, int value, long cycle, int cycles) {
                text.append((char) value);
            }

            @Override
            public void report(String message) {
                reports.add(message);
            }
        });
    }

    /** The text is that of simavr 1.6, except the voltage. */
    @Test
    public void aSketchPrintsAndMakesPulses() throws IOException {
        Atmega328p chip = chip(ProgramFile.read(hex("serial.hex"), Atmega328p.FLASH_BYTES));
        chip.run(20_000_000);
        assertEquals("4.50\r\n512\r\n200\r\n400\r\n601\r\n800\r\n1001\r\n1201\r\n", text.toString());
        assertEquals(List.of(), reports);
        int last = rises.size() - 2;
        assertEquals("490 Hz", 510 * 64, rises.get(last) - rises.get(last - 1));
        long fall = falls.stream().filter(each -> each > rises.get(last)).findFirst().orElseThrow();
        assertEquals("duty 64 of 255", 128 * 64, fall - rises.get(last));
    }

    /** Wire: no device acknowledges its address (error 2), and none sends a byte. SPI receives an open line. */
    @Test
    public void noDeviceIsOnTheBuses() throws IOException {
        chip(ProgramFile.read(hex("scan.hex"), Atmega328p.FLASH_BYTES)).run(16_000_000);
        assertEquals("0 0 126 0 0 0 0\r\n255\r\n", text.toString());
        assertEquals(List.of(), reports);
    }

    @Test
    public void aChangedDigitIsRefusedInWords() throws IOException {
        Random random = new Random(60);
        byte[] good = hex("serial.hex");
        for (int i = 0; i < 2000; i++) {
            byte[] bad = good.clone();
            int at = random.nextInt(bad.length);
            bad[at] = (byte) (bad[at] == '0' ? '1' : '0');
            String message = "";
            try {
                ProgramFile.read(bad, Atmega328p.FLASH_BYTES);
            } catch (IllegalArgumentException e) {
                message = e.getMessage();
            }
            assertTrue(i + ", offset " + at + ": " + message, message.startsWith("line ") || good[at] <= '\r');
        }
    }

    @Test
    public void randomCodeIsReportedAndRunsOn() {
        Random random = new Random(60);
        for (int i = 0; i < 50; i++) {
            byte[] program = new byte[Atmega328p.FLASH_BYTES];
            random.nextBytes(program);
            Atmega328p chip = chip(program);
            chip.run(200_000);
            assertTrue(chip.getCycle() >= 200_000);
        }
        assertTrue(reports.toString(), reports.stream().anyMatch(each -> each.contains("did it jump out")));
    }
}
