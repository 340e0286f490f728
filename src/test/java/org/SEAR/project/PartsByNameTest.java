// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;

import java.util.stream.Collectors;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.junit.Rule;
import org.junit.Test;

/** Scripts get and wire parts of robots by name. */
public class PartsByNameTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static String wires(Arduino uno) {
        return uno.getWires().stream()
            .map(wire -> wire.getPin() + " " + wire.getPart() + " " + wire.getRole().getWord())
            .collect(Collectors.joining(", "));
    }

    private static String refused(Runnable work) {
        return assertThrows(IllegalArgumentException.class, work::run).getMessage();
    }

    @Test
    public void aRobotHasItsPartsByName() {
        SEARrobot rover = Robots.rover("rover");
        assertSame(rover.getComponents().get(2), rover.getPart("leftMotor"));
        assertSame(rover.getWheels().get(0), rover.getPart("left"));
        assertEquals("SEARrobot \"rover\": part is \"Left\", legal: drive, body, leftMotor, rightMotor, left, "
            + "right, caster", refused(() -> rover.getPart("Left")));
    }

    @Test
    public void aPartOfTheOnlyRobotIsWiredByItsName() throws Exception {
        SEARrobot rover = Robots.rover("rover");
        Arduino uno = new Arduino("uno");
        uno.wire(9, "leftMotor", "pwm");
        uno.wire("7", "leftMotor", "direction");
        uno.wire(10, "rightMotor");
        Distance eye = new Distance("eye", "GP2Y0A21");
        rover.addComponent(eye);
        uno.wire("A0", "eye");
        rover.addComponent(uno);
        assertEquals("9 leftMotor pwm, 7 leftMotor direction, 10 rightMotor pwm, A0 eye volts", wires(uno));
        assertEquals(1, Project.read(project.folder()).getRobots().size());
    }

    @Test
    public void missingPartsAreReportedWithTheExistingOnes() {
        Arduino uno = new Arduino("uno");
        String nothing = refused(() -> uno.wire(9, "leftMotor"));
        assertEquals("Arduino \"uno\": part is \"leftMotor\", legal: a component of the robot; no robot has one "
            + "to wire yet, call addComponent(...) first", nothing);
        Robots.rover("rover");
        assertEquals("Arduino \"uno\": part is \"engine\", legal: a component of the robot, leftMotor, rightMotor",
            refused(() -> uno.wire(9, "engine")));
        assertEquals("Arduino \"uno\": the part for pin 9 is missing (None), legal: a component of the robot",
            refused(() -> uno.wire(9, (SearObject) null)));
        assertEquals("Arduino \"uno\": the part for pin 9 is missing (None), legal: a component of the robot",
            refused(() -> uno.wire(9, (String) null)));
    }

    @Test
    public void partNamesReferToTheRobotOfTheArduino() {
        Robots.rover("scout");
        SEARrobot rover = Robots.rover("rover");
        Arduino uno = new Arduino("uno");
        assertEquals("Arduino \"uno\": \"leftMotor\" is on several robots, legal: a part of Arduino "
            + "\"uno\"'s own robot; call robot.addComponent(...) first", refused(() -> uno.wire(9, "leftMotor")));
        rover.addComponent(uno);
        uno.wire(9, "leftMotor");
        assertEquals("9 leftMotor pwm", wires(uno));
    }
}
