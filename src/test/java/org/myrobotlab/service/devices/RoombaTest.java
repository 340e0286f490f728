// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;

import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.myrobotlab.service.Roomba;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.Serial;

/** Bytes of MyRobotLab's Roomba service, as the real one sends them. */
public class RoombaTest {
    private Roomba roomba;
    private Serial uart;

    @Before
    public void connect() throws Exception {
        roomba = (Roomba) Runtime.start("roomba", "Roomba");
        uart = Serial.connectVirtualUart("/dev/roomba");
        uart.setTimeout(60_000);
        roomba.connect("/dev/roomba");
        serial().connect("/dev/roomba", 57600, 8, 1, 0);
    }

    private static Serial serial() {
        return (Serial) Runtime.getService("serial");
    }

    @After
    public void release() {
        Runtime.releaseAll();
    }

    private void sends(String hex) throws InterruptedException {
        StringBuilder got = new StringBuilder();
        for (byte one : uart.read(hex.split(" ").length)) {
            got.append(got.length() == 0 ? "" : " ").append(String.format("%02X", one));
        }
        assertEquals(hex, got.toString());
        assertEquals(0, uart.available());
    }

    /** As in the real MyRobotLab: only the service named "serial" brings commands to the port. */
    @Test
    public void connectClosesItsPortAndTheErrorNamesTheRemedy() throws Exception {
        roomba.connect("/dev/roomba");
        assertFalse(serial().isConnected());
        assertFalse(roomba.connected());
        roomba.goForward();
        assertEquals("is not connected: MyRobotLab's Roomba closes its port after connect(port). After it, write "
            + "Runtime.getService(\"serial\").connect(\"/dev/roomba\", 57600, 8, 1, 0)", roomba.getLastError().key);
        serial().connect("/dev/roomba", 57600, 8, 1, 0);
        roomba.goForward();
        sends("89 00 C8 80 00");
    }

    @Test
    public void connectWithFiveArgumentsDoesNothing() {
        serial().disconnect();
        assertFalse(roomba.connect("/dev/roomba", 115200, 8, 1, 0));
        assertFalse(serial().isConnected());
        assertEquals("connect with five arguments does nothing, as in every MyRobotLab; write "
            + "Runtime.getService(\"serial\").connect(\"/dev/roomba\", 115200, 8, 1, 0)", roomba.getLastError().key);
    }

    @Test
    public void commandsAreTheBytesOfTheRealOne() throws InterruptedException {
        roomba.startup();
        sends("80");
        roomba.control();
        sends("82 8B 01 80 FF");
        roomba.goForward();
        sends("89 00 C8 80 00");
        roomba.goBackward();
        sends("89 FF 38 80 00");
        roomba.stop();
        sends("89 00 00 00 00");
        roomba.spinLeft();
        sends("89 00 C8 00 01");
        roomba.spinRight();
        sends("89 00 C8 FF FF");
        roomba.turnLeft();
        sends("89 00 C8 00 81");
        roomba.turnRight();
        sends("89 00 C8 FF 7F");
        assertFalse(roomba.updateSensors());
        sends("8E 00");
        roomba.reset();
        sends("89 00 00 00 00 80 82 8B 01 80 FF 8E 00");
        roomba.goForwardAt(300);
        sends("89 01 2C 80 00");
        roomba.drive(200, 500);
        sends("89 00 C8 01 F4");
        roomba.setSpeed(900);
        assertEquals(500, roomba.getSpeed());
    }

    @Test
    public void withoutAPortCommandsAreErrors() {
        roomba.disconnect();
        Roomba other = (Roomba) Runtime.start("other", "Roomba");
        other.goForward();
        assertEquals("is not connected: call connect(port) first, then write "
            + "Runtime.getService(\"serial\").connect(\"PORT\", 57600, 8, 1, 0)", other.getLastError().key);
    }
}
