// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.Bytes;
import org.SEAR.Golden;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.mrlcomm.MrlFunction;
import org.SEAR.protocol.mrlcomm.MrlMessage;
import org.SEAR.protocol.mrlcomm.MrlReader;
import org.junit.Test;

/** Exchanges with MrlComm 68, as in MyRobotLab's Arduino service. */
public class MrlCommTest {
    private static final Golden MRL_COMM = Golden.of("mrlcomm");
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
        return taken().stream().filter(message -> message.getFunction() == function)
            .map(message -> Bytes.hex(message.toBytes())).collect(Collectors.toList());
    }

    /** The service waits for the begin message, then asks for the board type. */
    @Test
    public void theHello() {
        uno.board.opened(0);
        uno.line.pass(1.01);
        byte[] hello = uno.line.take();
        assertEquals("MRLComm Reset.", new String(hello, 0, 63).trim());
        assertEquals(MRL_COMM.get("hello of a board"), Bytes.hex(Arrays.copyOfRange(hello, 63, hello.length)));
        assertEquals(MRL_COMM.get("an Uno with nothing attached", "ask for the board acknowledged"),
            uno.answer(MRL_COMM.get("ask for the board")));
        Boards mega = Boards.mrlComm(BoardModel.MEGA);
        assertEquals(MRL_COMM.get("a Mega with nothing attached", "ask for the board acknowledged"),
            mega.answer(MRL_COMM.get("ask for the board")));
    }

    @Test
    public void itSendsItsBoardInfoOnceASecond() {
        uno.line.pass(3.01);
        assertEquals(3, taken(MrlFunction.PUBLISH_BOARD_INFO).size());
    }

    @Test
    public void acknowledgementsCanBeSwitchedOff() {
        assertEquals(MRL_COMM.get("digital write acknowledged"), uno.answer(MRL_COMM.get("pin 13 high")));
        assertEquals("", uno.answer(MRL_COMM.get("no acknowledgements")));
        assertEquals("", uno.answer(MRL_COMM.get("pin 13 high")));
        assertEquals(MRL_COMM.get("the number echoed"), uno.answer(MRL_COMM.get("echo a number")));
    }

    /** Messages of MyRobotLab's Motor service for an H bridge. */
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
        uno.line.host(MRL_COMM.get("read analog pin 14 ten times a second", "read digital pin 4 ten times a second"));
        uno.line.take();
        uno.line.pass(1);
        List<String> told = taken(MrlFunction.PUBLISH_PIN_ARRAY);
        assertEquals(10, told.stream().filter(each -> each.contains("0E 02 00")).count(), 1);
        assertEquals(10, told.stream().filter(each -> each.contains("04 00 01")).count(), 1);
        uno.line.host(MRL_COMM.get("stop reading pin 14", "stop reading all pins"));
        uno.line.take();
        uno.line.pass(1);
        assertEquals(0, taken(MrlFunction.PUBLISH_PIN_ARRAY).size());
    }

    @Test
    public void aPinReadInEachLoopLeavesCapacityOnTheLine() {
        uno.probe(14).volts = 2.5;
        uno.line.host(MRL_COMM.get("read analog pin 14 in each loop"));
        uno.line.pass(2);
        assertTrue(uno.line.lineFreeAt() - uno.line.now < 0.1);
        assertEquals(1000 * 2, taken(MrlFunction.PUBLISH_PIN_ARRAY).size(), 300);
    }

    /** The UltrasonicSensor service: whole centimetres, sent on change. */
    @Test
    public void anUltrasonicSensor() {
        Boards.Probe trigger = uno.probe(7);
        trigger.second = uno.probe(8);
        trigger.echo = 123 * 57e-6;
        assertEquals(MRL_COMM.get("attach acknowledged", "start acknowledged"),
            uno.answer(MRL_COMM.get("attach a range finder 1 at pins 7 and 8", "start range finder 1")));
        uno.line.pass(0.5);
        assertEquals(List.of(MRL_COMM.get("range finder 1: 123 us")), taken(MrlFunction.PUBLISH_ULTRASONIC));
        trigger.echo = 0.038;
        uno.line.pass(0.5);
        assertEquals(List.of(MRL_COMM.get("range finder 1: nothing")), taken(MrlFunction.PUBLISH_ULTRASONIC));
        uno.line.host(MRL_COMM.get("stop range finder 1"));
        trigger.echo = 0.001;
        uno.line.take();
        uno.line.pass(0.5);
        assertEquals(0, taken(MrlFunction.PUBLISH_ULTRASONIC).size());
        assertEquals(MRL_COMM.get("an Uno with device 1", "ask for the board acknowledged"),
            uno.answer(MRL_COMM.get("ask for the board")));
    }

    /**
     * The Servo service: attached at 1472 us (90 degrees), then to 2400 us at 45 degrees a second, which takes two
     * seconds.
     */
    @Test
    public void aServo() {
        Boards.Probe servo = uno.probe(10);
        uno.line.host(MRL_COMM.get("attach the servo 3 at pin 10, 1472 us, 45 degrees a second"));
        assertEquals(1472, servo.micros);
        uno.line.take();
        uno.line.host(MRL_COMM.get("servo 3 to 2400 us"));
        uno.line.pass(1);
        assertEquals(List.of(MRL_COMM.get("servo 3 starts")), taken(MrlFunction.PUBLISH_SERVO_EVENT));
        assertEquals(1472 + 464, servo.micros, 5);
        uno.line.pass(1.1);
        assertEquals(2400, servo.micros);
        assertEquals(List.of(MRL_COMM.get("servo 3 has arrived")), taken(MrlFunction.PUBLISH_SERVO_EVENT));
        uno.line.host(MRL_COMM.get("servo 3 as fast as it goes", "servo 3 to 544 us"));
        uno.line.pass(0.1);
        assertEquals("no speed set: at once", 544, servo.micros);
        uno.line.host(MRL_COMM.get("switch servo 3 off"));
        assertEquals(0, servo.micros);
        uno.line.host(MRL_COMM.get("switch servo 3 on at pin 10"));
        assertEquals(544, servo.micros);
        uno.line.host(MRL_COMM.get("detach device 3"));
        assertEquals(0, servo.micros);
    }

    @Test
    public void illegalRequestsAreAnsweredWithAnError() {
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
        return taken().stream().filter(message -> message.getFunction() == MrlFunction.PUBLISH_ERROR)
            .map(message -> new String(message.getList(0))).collect(Collectors.joining());
    }

    @Test
    public void aSoftResetForgetsDevicesAndPins() {
        Boards.Probe servo = uno.probe(10);
        uno.line.host(MRL_COMM.get("attach the servo 3 at pin 10, 1472 us, 45 degrees a second",
            "read analog pin 14 ten times a second", "soft reset"));
        assertEquals(0, servo.micros);
        assertEquals(MRL_COMM.get("an Uno with nothing attached", "ask for the board acknowledged"),
            uno.answer(MRL_COMM.get("ask for the board")));
    }
}
