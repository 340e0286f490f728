// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import org.SEAR.Bytes;
import org.SEAR.Golden;
import org.SEAR.devices.FakeContext;
import org.junit.Test;

/** The Open Interface compared with test vectors and mode rules of its documents. */
public class RoombaFirmwareTest {
    private static final Golden OI = Golden.of("open-interface");
    private FakeContext line = new FakeContext();
    private RoombaFirmware roomba;

    private void power(OiModel model) {
        line = new FakeContext();
        roomba = line.attach(new RoombaFirmware(model, 57600, true, line));
    }

    private String ask(String hex) {
        line.take();
        line.host(hex);
        return line.takeHex();
    }

    private void drives(String hex, double left, double right) {
        line.host(hex);
        assertEquals(hex, left, line.hardware.left, 1e-6);
        assertEquals(hex, right, line.hardware.right, 1e-6);
    }

    @Test
    public void driveVectorsSetTheWheels() {
        power(OiModel.CREATE2);
        line.host("80 84");
        double share = 0.129 / 0.5;
        drives(OI.get("back at 200 mm/s, to the left around 500 mm, of the specification"), -0.2 * (1 - share),
            -0.2 * (1 + share));
        drives(OI.get("200 mm/s straight on"), 0.2, 0.2);
        drives(OI.get("200 mm/s straight on, the other number for it"), 0.2, 0.2);
        drives(OI.get("200 mm/s to the left on the spot"), -0.2, 0.2);
        drives(OI.get("200 mm/s to the right on the spot"), 0.2, -0.2);
        drives(OI.get("300 mm/s to the right around 2 m"), 0.3 * (1 + 0.129 / 2), 0.3 * (1 - 0.129 / 2));
        drives(OI.get("stand"), 0, 0);
        drives(OI.get("both wheels 200 mm/s"), 0.2, 0.2);
        drives(OI.get("right wheel 100 mm/s, left 100 mm/s back"), -0.1, 0.1);
        drives(OI.get("both wheels 200 mm/s back"), -0.2, -0.2);
        drives(OI.get("right wheel full duty, left full duty back"), -0.5, 0.5);
        drives(OI.get("1000 mm/s straight on, which is too fast"), 0.5, 0.5);
    }

    @Test
    public void aCircleTooFastForAWheelKeepsItsRadius() {
        power(OiModel.CREATE);
        line.host("80 83 89 01 F4 01 F4");
        assertEquals(0.5, line.hardware.right, 1e-6);
        double radius = 0.129 * (line.hardware.right + line.hardware.left) / (line.hardware.right - line.hardware.left);
        assertEquals(0.5, radius, 1e-6);
    }

    @Test
    public void createAndCreate2ChangeFromAnyModeToAny() {
        for (OiModel model : new OiModel[] {OiModel.CREATE, OiModel.CREATE2}) {
            power(model);
            assertEquals("", ask("8E 23"));
            assertEquals("01", ask("80 8E 23"));
            assertEquals("03", ask("84 8E 23"));
            assertEquals("02", ask("83 8E 23"));
            assertEquals("02", ask("82 8E 23"));
            assertEquals("01", ask("80 8E 23"));
        }
    }

    @Test
    public void theRoomba400ChangesModesStepByStep() {
        power(OiModel.ROOMBA400);
        line.host("80 84");
        assertEquals(OiMode.PASSIVE, roomba.getMode());
        line.host("83");
        assertEquals(OiMode.PASSIVE, roomba.getMode());
        line.host("82");
        assertEquals(OiMode.SAFE, roomba.getMode());
        line.host("84");
        assertEquals(OiMode.FULL, roomba.getMode());
        line.host("83");
        assertEquals(OiMode.SAFE, roomba.getMode());
        line.host("81 0A");
        assertEquals(OiMode.PASSIVE, roomba.getMode());
    }

    @Test
    public void sensorVectors() {
        power(OiModel.CREATE);
        line.host("80 83");
        assertEquals(OI.get("group 2 of a Create at rest"), ask("8E 02"));
        line.hardware.bumpLeft = true;
        line.hardware.bumpRight = true;
        assertEquals("03", ask("8E 07"));
        line.hardware.path = 0.1;
        assertEquals("00 64", ask("8E 13"));
        assertEquals("00 00", ask("8E 13"));
        line.hardware.turned = Math.toRadians(-45);
        assertEquals("FF D3", ask("8E 14"));
        assertEquals("02", ask("8E 23"));
        line.hardware.path = 0.35;
        line.hardware.turned = Math.toRadians(-135);
        assertEquals(OI.get("group 2 of a Create after 250 mm and 90 degrees to the right"), ask("8E 02"));
        power(OiModel.CREATE2);
        line.host("80");
        line.hardware.path = 0.25;
        line.hardware.turned = Math.toRadians(-90);
        assertEquals(OI.get("group 2 of a Create 2 after 250 mm and 90 degrees to the right"), ask("8E 02"));
        power(OiModel.ROOMBA400);
        line.host("80");
        line.hardware.turned = Math.toRadians(90);
        assertEquals(OI.get("group 2 of a Roomba 400 after 90 degrees to the left"), ask("8E 02"));
    }

    @Test
    public void theBatteryDrainsToTheDocumentsExample() {
        power(OiModel.CREATE);
        line.host("80");
        roomba.advance(3600 * 702 / 200.0);
        line.now = 3600 * 702 / 200.0;
        assertEquals(OI.get("group 3: the battery of the specification's example"), ask("8E 03"));
    }

    @Test
    public void groupsHaveTheirSizes() {
        int[][] sizes = {{0, 26}, {1, 10}, {2, 6}, {3, 10}, {4, 14}, {5, 12}, {6, 52}, {100, 80}, {101, 28},
            {106, 12}, {107, 9}};
        power(OiModel.CREATE2);
        line.host("80");
        for (int[] size : sizes) {
            line.take();
            line.host(142, size[0]);
            assertEquals("group " + size[0], size[1], line.take().length);
        }
        power(OiModel.ROOMBA400);
        line.host("80");
        assertEquals("", ask("8E 04"));
        assertFalse(line.warnings.isEmpty());
    }

    @Test
    public void countersHoldAtTheirLimits() {
        power(OiModel.CREATE);
        line.host("80");
        line.hardware.path = 50;
        assertEquals("7F FF", ask("8E 13"));
        line.hardware.path = -50;
        assertEquals("80 00", ask("8E 13"));
        line.hardware.path = -50.0004;
        assertEquals("00 00", ask("8E 13"));
        line.hardware.path = -50.0008;
        assertEquals("FF FF", ask("8E 13"));
    }

    @Test
    public void queryListAndEncoders() {
        power(OiModel.CREATE2);
        line.host("80");
        line.hardware.virtualWall = true;
        line.hardware.bumpRight = true;
        assertEquals("01 01", ask("95 02 07 0D"));
        assertEquals("00 01", ask("95 02 09 0D"));
        line.hardware.leftAngle = 2 * Math.PI;
        line.hardware.rightAngle = -2 * Math.PI;
        assertEquals("01 FC FE 03", ask("95 02 2B 2C"));
    }

    @Test
    public void streamChecksumsOfBothRules() {
        assertEquals(OI.get("stream of packets 29 and 13, its header summed"),
            Bytes.hex(Stream.frame(Bytes.bytes("1D 02 19 0D 00"), true)));
        assertEquals(OI.get("stream of packets 29 and 13, its header not summed"),
            Bytes.hex(Stream.frame(Bytes.bytes("1D 02 19 0D 00"), false)));
        assertEquals("13 02 07 00 E4", Bytes.hex(Stream.frame(Bytes.bytes("07 00"), true)));
        assertEquals("13 02 07 00 F7", Bytes.hex(Stream.frame(Bytes.bytes("07 00"), false)));
        assertEquals("13 02 23 02 C6", Bytes.hex(Stream.frame(Bytes.bytes("23 02"), true)));
        assertEquals("13 08 07 03 13 00 64 14 FF D3 7E",
            Bytes.hex(Stream.frame(Bytes.bytes("07 03 13 00 64 14 FF D3"), true)));
        assertEquals("13 08 07 03 13 00 64 14 FF D3 91",
            Bytes.hex(Stream.frame(Bytes.bytes("07 03 13 00 64 14 FF D3"), false)));
    }

    @Test
    public void aStreamComesEvery15MillisecondsUntilPaused() {
        power(OiModel.CREATE);
        line.host("80 94 02 1D 0D");
        line.take();
        double from = line.now;
        line.pass(3);
        byte[] sent = line.take();
        assertEquals(3 / 0.015, sent.length / 8.0, 1.01);
        assertEquals("13 05 1D 07 D0 0D 00 E7", Bytes.hex(Arrays.copyOf(sent, 8)));
        assertTrue(line.now > from);
        line.host("96 00");
        line.take();
        line.pass(1);
        assertEquals(0, line.take().length);
        line.host("96 01");
        line.pass(1);
        assertTrue(line.take().length >= 8 * 65);
    }

    @Test
    public void safeModeTripsOnCliffAndWheelDrop() {
        power(OiModel.CREATE);
        line.host("80 83 89 00 C8 80 00");
        line.pass(0.1);
        assertEquals(OiMode.SAFE, roomba.getMode());
        line.hardware.floorAhead = 5;
        line.pass(0.02);
        assertEquals(OiMode.PASSIVE, roomba.getMode());
        assertEquals(0, line.hardware.left, 0);
        assertEquals("an emergency stop", 1, line.hardware.braked);
        line.host("83 89 FF 38 80 00");
        line.pass(0.1);
        assertEquals("backing away from a cliff", OiMode.SAFE, roomba.getMode());
        line.hardware.dropLeft = true;
        line.pass(0.02);
        assertEquals(OiMode.PASSIVE, roomba.getMode());
        line.host("84 89 00 C8 80 00");
        line.pass(0.1);
        assertEquals("full mode does not mind", OiMode.FULL, roomba.getMode());
        assertEquals("01", ask("8E 0A"));
        assertTrue(line.warnings.toString(), line.warnings.get(0).startsWith("a cliff: the robot left safe mode"));
        assertTrue(line.warnings.toString(), line.warnings.get(1)
            .startsWith("a wheel has dropped: the robot left safe mode"));
    }

    @Test
    public void theScriptOf40CentimetresDrivesAndStops() {
        power(OiModel.CREATE);
        line.host(OI.get("40 cm of the specification, a script"));
        assertEquals(OI.get("the script of 40 cm, shown"), ask("9A"));
        line.host("99");
        line.pass(0.05);
        assertEquals(0.3, line.hardware.left, 1e-9);
        assertEquals("deaf while it waits", "", ask("8E 23"));
        line.hardware.path = 0.39;
        line.pass(0.1);
        assertEquals(0.3, line.hardware.left, 1e-9);
        line.hardware.path = 0.401;
        line.pass(0.05);
        assertEquals(0, line.hardware.left, 0);
        assertEquals("02", ask("8E 23"));
    }

    @Test
    public void theScriptOfTheSquareDrivesASquare() {
        power(OiModel.CREATE);
        line.host(OI.get("square of the specification, a script that plays itself"));
        for (int side = 0; side < 4; side++) {
            line.pass(0.1);
            assertEquals(0.3, line.hardware.left, 1e-9);
            line.hardware.path += 0.401;
            line.pass(0.1);
            assertEquals(-0.3, line.hardware.left, 1e-9);
            line.hardware.turned += Math.toRadians(90.5);
        }
    }

    @Test
    public void theScriptOfTheBumperTogglesTheLight() {
        power(OiModel.CREATE);
        line.host(OI.get("light by the bumper of the specification, a script that plays itself"));
        for (int i = 0; i < 2; i++) {
            press();
            assertEquals(2, roomba.getLights().getBits());
            press();
            assertEquals(0, roomba.getLights().getBits());
        }
    }

    private void press() {
        line.pass(0.1);
        line.hardware.bumpLeft = true;
        line.pass(0.1);
        line.hardware.bumpLeft = false;
        line.pass(0.1);
    }

    @Test
    public void songsPlayToTheirEnd() {
        power(OiModel.CREATE);
        line.host("80 83 8C 02 02 40 20 41 20 8D 02");
        assertEquals("02 01", ask("95 02 24 25"));
        line.pass(0.9);
        assertEquals("02 01", ask("95 02 24 25"));
        line.pass(0.2);
        assertEquals("02 00", ask("95 02 24 25"));
    }

    /** As in pycreate2's safe(). */
    @Test
    public void aSongOfNoDurationIsASongAndEachMistakeIsNamed() {
        power(OiModel.CREATE2);
        line.host("80 83 8C 02 01 40 00 8D 02");
        assertEquals("[]", line.warnings.toString());
        line.host("8D 03 8D 03 8D 09 8C 09 01 40 20 90 00 00 00");
        assertEquals("[song 3 is not defined: command 141 (PLAY) is ignored, command 141 (PLAY) with first argument 9 "
            + "is not possible on a create2:"
            + " ignored, command 140 (SONG) with first argument 9 is not possible on a create2: ignored]",
                line.warnings.toString());
    }

    @Test
    public void baudChangesAndUnknownOpcodesAreNamed() {
        power(OiModel.CREATE);
        line.host("80 81 0B");
        assertEquals(115200, roomba.getBaud());
        line.host("81 0A");
        assertEquals(57600, roomba.getBaud());
        line.host("81 07");
        assertEquals(19200, roomba.getBaud());
        line.host(200);
        assertTrue(line.warnings.toString(), line.warnings.get(0).contains("opcode 200"));
        assertEquals("01", ask("8E 23"));
        line.host(OI.get("200 mm/s straight on"));
        assertEquals(0, line.hardware.left, 0);
        assertTrue(line.warnings.toString(), line.warnings.get(1).contains("137"));
    }

    @Test
    public void everyCommandTakesItsArguments() {
        String[] create2 = {"8B 04 00 80", "8A 0D", "A7 28 00 00 00 00 00 00 0F 00 00 00 0A 24 00 00", "A2 00 00",
            "A3 00 00 00 00",
            "A4 41 42 43 44", "A5 00", "A8 00 00 00", "90 00 00 00", "86 83", "87 83", "88 83", "8F 83"};
        String[] create = {"90 20 00 80", "93 00", "97 00", "8B 08 00 80", "88 FF 83", "9B 00", "98 00"};
        for (OiModel model : new OiModel[] {OiModel.CREATE, OiModel.CREATE2}) {
            for (String command : model == OiModel.CREATE ? create : create2) {
                power(model);
                line.host("80 83 " + command);
                line.pass(0.03);
                assertEquals(command, "02", ask("8E 23"));
            }
        }
    }

    @Test
    public void aSleepingRoombaWakesOnlyOnStart() {
        power(OiModel.CREATE2);
        line.host("80 83 85");
        assertEquals("", ask("8E 23"));
        assertEquals("01", ask("80 8E 23"));
        line.pass(301);
        assertEquals("", ask("8E 23"));
        assertEquals("01", ask("80 8E 23"));
        assertEquals("", ask("AD 8E 23"));
        assertTrue(ask("07").length() > 0);
        assertEquals(OiMode.OFF, roomba.getMode());
    }

    @Test
    public void aResetIsAFreshStart() {
        power(OiModel.CREATE);
        String fresh = roomba.status();
        line.host("80 84 8B FF FF FF 94 01 07");
        line.pass(1);
        roomba.reset();
        assertEquals(fresh, roomba.status());
    }

    @Test
    public void thePowerSwitchEndsModeStreamAndBaudRate() {
        for (OiModel model : OiModel.values()) {
            power(model);
            line.host(model.isLadder() ? "80 82 89 00 C8 80 00" : "80 81 07");
            line.host(model.isLadder() ? "" : "83 89 00 C8 80 00 94 01 07");
            line.pass(1);
            assertEquals(model.isLadder() ? 57600 : 19200, roomba.getBaud());
            assertEquals(0.2, line.hardware.left, 1e-6);
            roomba.powerOff();
            assertEquals("motors have no power", 0, line.hardware.left, 0);
            line.now += 100;
            line.take();
            roomba.powerOn(line.now);
            line.pass(1);
            assertEquals("only a Create 2 says that it boots", model == OiModel.CREATE2
                ? "bl-start\r\nRoomba by iRobot!\r\n" : "", line.takeText());
            assertEquals(57600, roomba.getBaud());
            assertEquals(OiMode.OFF, roomba.getMode());
            assertEquals("", ask("8E 07"));
            assertTrue("it listens", ask("80 8E 02").length() > 0);
        }
    }

    @Test
    public void theBatteryKeepsItsChargeWithoutPower() {
        power(OiModel.CREATE);
        line.host("80");
        line.pass(60);
        String used = ask("8E 19");
        roomba.powerOff();
        roomba.powerOn(line.now);
        line.pass(0.1);
        assertEquals(used, ask("80 8E 19"));
    }
}
