package org.SEAR.devices.arduino;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.Bytes;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.mrlcomm.MrlFunction;
import org.SEAR.protocol.mrlcomm.MrlMessage;
import org.SEAR.protocol.mrlcomm.MrlReader;
import org.junit.Test;

/** Exchanges with MrlComm 68 as MyRobotLab's Arduino service has them. */
public class MrlCommTest {
    private final Boards uno = Boards.mrlComm(BoardModel.UNO);

    private List<MrlMessage> taken() {
        List<MrlMessage> found = new ArrayList<>();
        MrlReader reader = new MrlReader(found::add, number -> {
            throw new AssertionError(number);
        });
        for (byte each : uno.line.take()) {
            reader.accept(each & 0xFF);
        }
        return found;
    }

    private List<String> taken(MrlFunction function) {
        return taken().stream().filter(message -> message.getFunction() == function).map(message -> Bytes.hex(message.toBytes()))
            .collect(Collectors.toList());
    }

    /** The service waits for the begin, then asks what board it is. */
    @Test
    public void theHello() {
        uno.board.opened(0);
        uno.line.pass(1.01);
        byte[] hello = uno.line.take();
        assertEquals("MRLComm Reset.", new String(hello, 0, 63).trim());
        assertEquals("AA 02 3A 44", Bytes.hex(Arrays.copyOfRange(hello, 63, hello.length)));
        assertEquals("AA 09 03 44 02 03 E8 04 00 00 00 AA 02 09 02", uno.answer("AA 01 02"));
        Boards mega = Boards.mrlComm(BoardModel.MEGA);
        assertEquals("AA 09 03 44 01 03 E8 04 00 00 00 AA 02 09 02", mega.answer("AA 01 02"));
    }

    @Test
    public void itSaysWhatItIsOnceASecond() {
        uno.line.pass(3.01);
        assertEquals(3, taken(MrlFunction.PUBLISH_BOARD_INFO).size());
    }

    @Test
    public void acknowledgementsCanBeSwitchedOff() {
        assertEquals("AA 02 09 1B", uno.answer("AA 03 1B 0D 01"));
        assertEquals("", uno.answer("AA 02 08 00"));
        assertEquals("", uno.answer("AA 03 1B 0D 01"));
        assertEquals("AA 0A 0B 3F 80 00 00 07 C0 00 00 00", uno.answer("AA 0A 0A 3F 80 00 00 07 C0 00 00 00"));
    }

    /** How its Motor service drives an H bridge. */
    @Test
    public void aMotorByDirectionAndPwm() {
        Boards.Probe direction = uno.probe(8);
        Boards.Probe pwm = uno.probe(9);
        uno.line.host("AA 03 1E 08 01 AA 03 1E 09 01 AA 03 1B 08 01 AA 03 1A 09 FF");
        assertEquals(1, direction.level, 0);
        assertEquals(1, pwm.level, 0);
        uno.line.host("AA 03 1B 08 00 AA 03 1A 09 33");
        assertEquals(0, direction.level, 0);
        assertEquals(0.2, pwm.level, 1e-9);
    }

    @Test
    public void pinsAreReadAtTheirRate() {
        uno.probe(14).volts = 2.5;
        uno.probe(4).volts = 5;
        uno.line.host("AA 05 04 0E 01 00 0A AA 05 04 04 00 00 0A");
        uno.line.take();
        uno.line.pass(1);
        List<String> told = taken(MrlFunction.PUBLISH_PIN_ARRAY);
        assertEquals(10, told.stream().filter(each -> each.contains("0E 02 00")).count(), 1);
        assertEquals(10, told.stream().filter(each -> each.contains("04 00 01")).count(), 1);
        uno.line.host("AA 02 1C 0E AA 01 1D");
        uno.line.take();
        uno.line.pass(1);
        assertEquals(0, taken(MrlFunction.PUBLISH_PIN_ARRAY).size());
    }

    @Test
    public void aPinThatIsReadInEachLoopLeavesRoomOnTheLine() {
        uno.probe(14).volts = 2.5;
        uno.line.host("AA 05 04 0E 01 00 00");
        uno.line.pass(2);
        assertTrue(uno.line.lineFreeAt() - uno.line.now < 0.1);
        assertEquals(1000 * 2, taken(MrlFunction.PUBLISH_PIN_ARRAY).size(), 300);
    }

    /** The UltrasonicSensor service: whole centimetres, told when they change. */
    @Test
    public void anUltrasonicSensor() {
        Boards.Probe trigger = uno.probe(7);
        trigger.second = uno.probe(8);
        trigger.echo = 123 * 57e-6;
        assertEquals("AA 02 09 2F AA 02 09 30", uno.answer("AA 04 2F 01 07 08 AA 02 30 01"));
        uno.line.pass(0.5);
        assertEquals(List.of("AA 04 32 01 00 7B"), taken(MrlFunction.PUBLISH_ULTRASONIC));
        trigger.echo = 0.038;
        uno.line.pass(0.5);
        assertEquals(List.of("AA 04 32 01 00 00"), taken(MrlFunction.PUBLISH_ULTRASONIC));
        uno.line.host("AA 02 31 01");
        trigger.echo = 0.001;
        uno.line.take();
        uno.line.pass(0.5);
        assertEquals(0, taken(MrlFunction.PUBLISH_ULTRASONIC).size());
        assertEquals("AA 0A 03 44 02 03 E8 04 00 00 01 01 AA 02 09 02", uno.answer("AA 01 02"));
    }

    /** The Servo service: attached at 1472 us, 90 degrees, then to 2400 with 45 degrees a second, which takes two seconds. */
    @Test
    public void aServo() {
        Boards.Probe servo = uno.probe(10);
        uno.line.host("AA 0D 23 03 0A 05 C0 00 2D 05 73 65 72 76 6F");
        assertEquals(1472, servo.micros);
        uno.line.take();
        uno.line.host("AA 04 29 03 09 60");
        uno.line.pass(1);
        assertEquals(List.of("AA 07 2B 03 00 05 C0 09 60"), taken(MrlFunction.PUBLISH_SERVO_EVENT));
        assertEquals(1472 + 464, servo.micros, 5);
        uno.line.pass(1.1);
        assertEquals(2400, servo.micros);
        assertEquals(List.of("AA 07 2B 03 01 09 60 09 60"), taken(MrlFunction.PUBLISH_SERVO_EVENT));
        uno.line.host("AA 04 26 03 FF FF AA 04 29 03 02 20");
        uno.line.pass(0.1);
        assertEquals("no speed set: at once", 544, servo.micros);
        uno.line.host("AA 02 25 03");
        assertEquals(0, servo.micros);
        uno.line.host("AA 03 24 03 0A");
        assertEquals(544, servo.micros);
        uno.line.host("AA 02 0E 03");
        assertEquals(0, servo.micros);
    }

    @Test
    public void whatCantBeIsToldAsAnError() {
        assertTrue(errors("AA 05 04 63 01 00 00").contains("no pin 99"));
        assertTrue(errors("AA 02 30 09").contains("device does not exist"));
        assertTrue(errors("AA 04 2F 01 00 08").contains("legal 2 to 13, A0 to A5"));
        assertTrue(errors("AA 03 0F 01 00").contains("I2C_BUS_ATTACH: nothing like that can be wired"));
        assertTrue(errors("AA 01 63").contains("unknown function 99"));
        assertFalse(uno.line.warnings.isEmpty());
    }

    private String errors(String hex) {
        uno.line.take();
        uno.line.host(hex);
        return taken().stream().filter(message -> message.getFunction() == MrlFunction.PUBLISH_ERROR).map(message -> new String(message.getList(0)))
            .collect(Collectors.joining());
    }

    @Test
    public void aSoftResetForgetsDevicesAndPins() {
        Boards.Probe servo = uno.probe(10);
        uno.line.host("AA 0D 23 03 0A 05 C0 00 2D 05 73 65 72 76 6F AA 05 04 0E 01 00 0A AA 01 07");
        assertEquals(0, servo.micros);
        assertEquals("AA 09 03 44 02 03 E8 04 00 00 00 AA 02 09 02", uno.answer("AA 01 02"));
    }
}
