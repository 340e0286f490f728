// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.SEAR.Golden;
import org.SEAR.protocol.arduino.BoardModel;
import org.junit.Test;

/** Exchanges with StandardFirmata 2.5 as in protocol.md, in the order of the drivers' requests. */
public class FirmataTest {
    private static final Golden FIRMATA = Golden.of("firmata");
    private static final String FIRMWARE = FIRMATA.get("StandardFirmata.ino 2.5");
    private static final String DIGITAL = "00 01 0B 01 01 01 04 0E 7F ";
    private static final String PWM = "00 01 0B 01 01 01 03 08 04 0E 7F ";
    private static final String ANALOG = "00 01 0B 01 01 01 02 0A 04 0E 7F ";
    private static final String TWO_WIRE = "00 01 0B 01 01 01 02 0A 04 0E 06 01 7F ";

    private final Boards uno = Boards.firmata(BoardModel.UNO);

    /** One second of boot loader, 2.125 s of blinking, then version and name. */
    @Test
    public void anOpenedPortResetsTheBoard() {
        uno.line.host(FIRMATA.get("pin 13 an output by its own message, high"));
        assertTrue(uno.pins.read(13));
        uno.board.opened(uno.line.now);
        assertFalse(uno.pins.mode(13) == Pins.Mode.OUTPUT);
        uno.line.take();
        uno.line.host("F9");
        uno.line.pass(0.99);
        assertEquals("", uno.line.takeHex());
        uno.line.pass(0.1);
        uno.line.host("F9");
        uno.line.pass(3);
        assertEquals("what came while it blinked is answered at its end",
            FIRMATA.get("version 2.5") + " " + FIRMWARE + " " + FIRMATA.get("version 2.5"), uno.line.takeHex());
        assertFalse(uno.pins.read(13));
    }

    /** Requests of firmata.js and johnny-five: version, name, capabilities, analog mapping. */
    @Test
    public void theHandshakeOfJohnnyFive() {
        assertEquals(FIRMATA.get("version 2.5"), uno.answer("F9"));
        assertEquals(FIRMWARE, uno.answer(FIRMATA.get("ask for the firmware")));
        assertEquals(("F0 6C 7F 7F " + DIGITAL + PWM + DIGITAL + PWM + PWM + DIGITAL + DIGITAL + PWM + PWM + PWM
            + DIGITAL + DIGITAL + ANALOG + ANALOG
            + ANALOG + ANALOG + TWO_WIRE + TWO_WIRE + "F7"), uno.answer(FIRMATA.get("ask for the capabilities")));
        assertEquals(FIRMATA.get("analog pins of an Uno"), uno.answer(FIRMATA.get("ask for the analog pins")));
    }

    @Test
    public void aMegaHasItsOwnPins() {
        Boards mega = Boards.firmata(BoardModel.MEGA);
        String answer = mega.answer(FIRMATA.get("ask for the capabilities"));
        assertEquals(70, answer.split("7F", -1).length - 1);
        assertEquals(16, answer.split("02 0A", -1).length - 1);
        assertEquals(15, answer.split("03 08", -1).length - 1);
        assertEquals(48, answer.split("04 0E", -1).length - 1);
        assertTrue(mega.answer(FIRMATA.get("ask for the analog pins"))
            .endsWith("7F 00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F F7"));
    }

    /** Requests of pyFirmata2 for an analog pin and its sampling. */
    @Test
    public void voltagesAreSentAtEachSample() {
        Boards.Probe sharp = uno.probe(14);
        sharp.volts = 2.5;
        assertEquals("E0 00 04", uno.answer("C0 01"));
        uno.line.host(FIRMATA.get("a sample each 19 ms"));
        uno.line.take();
        uno.line.pass(1);
        String[] told = uno.line.takeHex().split("(?=E0)");
        assertEquals(1000 / 19, told.length, 1);
        assertEquals("E0 00 04", told[10].trim());
        sharp.volts = 5;
        uno.line.pass(0.1);
        assertTrue(uno.line.takeHex().endsWith("E0 7F 07"));
        uno.line.host("C0 00");
        uno.line.take();
        uno.line.pass(1);
        assertEquals("", uno.line.takeHex());
    }

    @Test
    public void levelsAreReportedOnChange() {
        Boards.Probe contact = uno.probe(4);
        contact.volts = 5;
        assertEquals("90 10 00", uno.answer(FIRMATA.get("pin 4 an input, its port told")));
        uno.line.pass(1);
        assertEquals("", uno.line.takeHex());
        contact.volts = 0;
        uno.line.pass(0.1);
        assertEquals("90 00 00", uno.line.takeHex());
    }

    /** An open contact floats; with the pull-up it is high. */
    @Test
    public void aPullUpHoldsAnOpenContact() {
        uno.probe(4);
        assertEquals("90 10 00", uno.answer(FIRMATA.get("pin 4 an input with pull-up, its port told")));
        assertEquals(FIRMATA.get("state of pin 4: pull-up"), uno.answer(FIRMATA.get("ask for the state of pin 4")));
        uno.line.pass(1);
        assertEquals("", uno.line.takeHex());
        uno.line.host("F4 05 00");
        uno.line.pass(1);
        assertTrue("pin 5 floats", uno.line.takeHex().split("90", -1).length > 10);
    }

    @Test
    public void outputsGetLevelsDutiesAndPulses() {
        Boards.Probe led = uno.probe(13);
        Boards.Probe motor = uno.probe(9);
        Boards.Probe servo = uno.probe(10);
        uno.line.host(FIRMATA.get("pin 13 an output, high"));
        assertEquals(1, led.level, 0);
        uno.line.host("F5 0D 00");
        assertEquals(0, led.level, 0);
        uno.line.host(FIRMATA.get("pin 9 PWM, full"));
        assertEquals(127 / 255.0, motor.level, 1e-9);
        uno.line.host(FIRMATA.get("pin 9 by extended analog, full"));
        assertEquals(1, motor.level, 0);
        assertEquals(FIRMATA.get("state of pin 9: PWM, full"), uno.answer(FIRMATA.get("ask for the state of pin 9")));
        uno.line.host(FIRMATA.get("pin 10 a servo at 90 degrees"));
        assertEquals(1472, servo.micros);
        uno.line.host(FIRMATA.get("a servo of 1000 to 2000 us at pin 10, at 180 degrees"));
        assertEquals("1000 to 2000 us, 180 degrees", 2000, servo.micros);
        uno.line.host("EA 5C 0B");
        assertEquals(1500, servo.micros);
        uno.line.host("F4 0A 01");
        assertEquals(0, servo.micros);
        assertEquals(FIRMATA.get("pin 99 has no state"), uno.answer(FIRMATA.get("ask for the state of pin 99")));
    }

    /** Reset to defaults: no answer, no reports, outputs low. */
    @Test
    public void aResetForgetsEverything() {
        Boards.Probe motor = uno.probe(9);
        uno.probe(14).volts = 1;
        uno.line.host("F4 09 03 E9 7F 00 C0 01 D1 01");
        assertEquals("", uno.answer("FF"));
        assertEquals(0, motor.level, 0);
        uno.line.pass(1);
        assertEquals("", uno.line.takeHex());
    }

    /** johnny-five's HC-SR04 at pin 7. */
    @Test
    public void echoes() {
        Boards.Probe ping = uno.probe(7);
        ping.echo = 0.001;
        assertTrue(uno.answer(FIRMATA.get("ask for the capabilities")).contains("00 01 0B 01 01 01 04 0E 75 01 7F"));
        String request = FIRMATA.get("ping at pin 7: 5 us high, a second's patience");
        assertEquals(FIRMATA.get("echo at pin 7 after 1000 us"), uno.answer(request));
        ping.echo = Double.POSITIVE_INFINITY;
        uno.line.pass(0.1);
        assertEquals(FIRMATA.get("no echo at pin 7"), uno.answer(request));
        uno.line.host("F9");
        assertEquals("it waits for an echo that doesn't come", "", uno.line.takeHex());
        uno.line.pass(1.1);
        assertEquals(FIRMATA.get("version 2.5"), uno.line.takeHex());
    }

    @Test
    public void encoders() {
        Boards.Probe first = uno.probe(2);
        first.second = uno.probe(3);
        first.counts = 1000;
        assertTrue(uno.answer(FIRMATA.get("ask for the capabilities")).contains("09 1C"));
        assertEquals("", uno.answer(FIRMATA.get("attach encoder 2 at pins 2 and 3")));
        first.counts = 700;
        assertEquals(FIRMATA.get("encoder 2 at -300"), uno.answer(FIRMATA.get("ask for encoder 2")));
        assertEquals(FIRMATA.get("encoder 2 at -300"), uno.answer(FIRMATA.get("ask for all encoders")));
        uno.line.host(FIRMATA.get("reset encoder 2", "tell encoders by themselves"));
        uno.line.pass(0.1);
        assertTrue(uno.line.takeHex().startsWith("F0 61 02 00 00 00 00 F7 F0 61 02"));
        uno.line.host(FIRMATA.get("detach encoder 2"));
        uno.line.take();
        uno.line.pass(0.1);
        assertEquals("", uno.line.takeHex());
    }

    @Test
    public void theI2cBusIsEmpty() {
        assertTrue(uno.answer(FIRMATA.get("read a byte of the bus device 1E")).startsWith("F0 71 49 00 32 00 43 00"));
        assertTrue(uno.line.warnings.toString(), uno.line.warnings.get(0).contains("I2C"));
    }

    /** Samples beyond the line's capacity are dropped, not queued. */
    @Test
    public void samplesBeyondTheLinesCapacityAreDropped() {
        for (int channel = 0; channel < 6; channel++) {
            uno.line.host(0xC0 + channel, 1);
        }
        uno.line.host(FIRMATA.get("a sample each millisecond"));
        uno.line.pass(2);
        assertTrue(uno.line.lineFreeAt() - uno.line.now < 0.1);
        assertTrue(uno.line.take().length > 10000);
    }
}
