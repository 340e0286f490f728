// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.devices.FakeContext;
import org.SEAR.devices.arduino.avr.SketchTest;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.ProgramFile;
import org.junit.Before;
import org.junit.Test;

/** A board that runs the compiled sketch board.ino, with probes at its pins. */
public class SketchBoardTest {
    private final FakeContext line = new FakeContext();
    private final Probe[] probes = new Probe[20];
    private SketchPins pins;
    private SketchBoard board;

    /** A probe that also records pulses, is triggered, and turns an encoder by its edges. */
    private static final class Probe extends Boards.Probe {
        final List<Integer> pulses = new ArrayList<>();
        PinWire echoAt;
        Encoder encoder;

        @Override
        public void pulse(int newMicros) {
            pulses.add(newMicros);
        }

        @Override
        public boolean triggers(PinWire listened) {
            return listened == echoAt;
        }

        @Override
        public double echo(PinWire listened) {
            return echo;
        }

        @Override
        public Encoder track() {
            return encoder;
        }

        @Override
        public boolean isHigh(long newCounts) {
            return (newCounts & 2) != 0;
        }
    }

    static byte[] program(String name) throws IOException {
        try (InputStream in = SketchTest.class.getResourceAsStream(name)) {
            return ProgramFile.read(in.readAllBytes(), BoardModel.UNO.getFlash());
        }
    }

    @Before
    public void wire() {
        pins = new SketchPins(BoardModel.UNO, "test", line);
        for (int pin : new int[] {2, 4, 5, 7, 10, 11, 12, 13, 14}) {
            probes[pin] = new Probe();
            pins.connect(pin, probes[pin]);
        }
    }

    private void start() throws IOException {
        board = line.attach(new SketchBoard("Uno, board.hex", 115200, program("board.hex"), pins, line));
    }

    private String ask(String request, double seconds) {
        line.take();
        line.hostText(request);
        line.pass(seconds);
        return new String(line.take(), StandardCharsets.US_ASCII);
    }

    @Test
    public void theSketchSetsTheBaudRate() throws IOException {
        start();
        assertEquals("no UART is on at power-on", 115200, board.getBaud());
        assertTrue(board.matches(300));
        line.pass(0.1);
        assertEquals("ready\r\n", new String(line.take(), StandardCharsets.US_ASCII));
        assertEquals("UBRR 207 at double speed", 9615, board.getBaud());
        assertTrue(board.matches(9600));
        assertFalse(board.matches(115200));
        assertFalse(board.matches(10000));
        assertEquals("Uno, board.hex: running, 9615 baud", board.status());
        assertEquals(0, line.warnings.size());
    }

    @Test
    public void aLedBlinksTwicePerSecond() throws IOException {
        start();
        List<Double> changes = new ArrayList<>();
        for (double last = 0; line.now < 2.9; last = probes[13].level) {
            line.pass(1 / 60.0);
            if (probes[13].level != last) {
                changes.add(line.now);
            }
        }
        assertEquals(11, changes.size());
        for (int i = 0; i < changes.size(); i++) {
            assertEquals(0.25 * (i + 1), changes.get(i), 0.02);
        }
    }

    @Test
    public void pulsesGiveTheirDuty() throws IOException {
        start();
        line.pass(0.1);
        assertEquals("fast PWM of timer 0: 65 of 256", 65 / 256.0, probes[5].level, 1e-9);
        assertEquals("5 probe: pwm, 25 %", state(5));
        ask("w200\n", 0.1);
        assertEquals(201 / 256.0, probes[5].level, 1e-9);
        ask("w0\n", 0.1);
        assertEquals("low", 0, probes[5].level, 0);
        ask("w255\n", 0.1);
        assertEquals("high", 1, probes[5].level, 0);
        assertEquals("5 probe: output, high", state(5));
    }

    private String state(int pin) {
        return board.pinStates().stream().map(Object::toString)
            .filter(each -> each.startsWith(BoardModel.UNO.nameOf(pin) + " ")).findFirst().orElse("");
    }

    @Test
    public void servoPulsesHaveTheirWidth() throws IOException {
        start();
        line.pass(0.5);
        assertEquals(25, probes[10].pulses.size(), 1);
        assertEquals(List.of(1473), probes[10].pulses.subList(0, 1));
        probes[10].pulses.clear();
        ask("s2000\n", 1.5);
        assertEquals("OCR1B + 1 half microseconds", 2001, (int) probes[10].pulses.get(probes[10].pulses.size() - 1));
        assertEquals("pulses at 980 Hz move no servo", 0, probes[5].pulses.size());
    }

    /** pulseIn misses 5 us of each interrupt of timer 0, one per 1024 us, as on the real chip. */
    @Test
    public void anEchoLastsAsLongAsTheSoundTravels() throws IOException {
        probes[12].echoAt = probes[11];
        probes[12].echo = 0.005;
        probes[7].echoAt = probes[7];
        probes[7].echo = 0.0123;
        start();
        line.pass(0.1);
        assertEquals("HC-SR04", 5000, Integer.parseInt(ask("h", 0.2).trim()), 40);
        assertEquals("PING)))", 12300, Integer.parseInt(ask("p", 0.2).trim()), 80);
        probes[12].echo = SensorWire.HC_SILENCE;
        assertEquals("without an echo", 38000, Integer.parseInt(ask("h", 0.2).trim()), 250);
    }

    @Test
    public void analogAndDigitalInputs() throws IOException {
        probes[14].volts = 3.3;
        start();
        line.pass(0.1);
        assertEquals("675\r\n", ask("a", 0.1));
        assertEquals("pull-up", "1\r\n", ask("d", 0.1));
        probes[4].volts = 0;
        assertEquals("0\r\n", ask("d", 0.1));
    }

    /** Four counts make two edges of one track; no edge is lost within a step of 1/60 s. */
    @Test
    public void encoderEdgesReachInterrupts() throws IOException {
        long[] counts = {0};
        probes[2].encoder = () -> counts[0];
        start();
        line.pass(0.1);
        for (int i = 0; i < 60; i++) {
            counts[0] += 40;
            line.pass(1 / 60.0);
        }
        assertEquals("1200\r\n", ask("e", 0.1));
    }

    /** The boot loader loses the first request. */
    @Test
    public void openingThePortResetsTheBoard() throws IOException {
        start();
        line.pass(0.3);
        line.take();
        board.opened(line.now);
        assertTrue(board.isStarting());
        assertTrue("pins float", Double.isNaN(probes[5].level) || probes[5].level == 0);
        assertEquals("", ask("d", 0.9));
        line.pass(0.2);
        assertEquals("ready\r\n", new String(line.take(), StandardCharsets.US_ASCII));
        assertEquals("1\r\n", ask("d", 0.1));
    }

    @Test
    public void twoRunsSendTheSameBytesAtTheSameTimes() throws IOException {
        start();
        String first = run();
        line.restart();
        assertEquals(first, run());
    }

    private String run() {
        line.times.clear();
        probes[10].pulses.clear();
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 10; i++) {
            text.append(ask("a", 0.05));
        }
        return text.toString() + line.times + probes[10].pulses.size();
    }

    /** A program of words that are no instructions is reported once per address, at most twenty times. */
    @Test
    public void nonsenseIsReportedAndTheTimeGoesOn() {
        byte[] program = new byte[BoardModel.UNO.getFlash()];
        Arrays.fill(program, (byte) 0xFF);
        board = line.attach(new SketchBoard("Uno", 9600, program, pins, line));
        line.pass(0.1);
        assertEquals(20, line.warnings.size());
    }
}
