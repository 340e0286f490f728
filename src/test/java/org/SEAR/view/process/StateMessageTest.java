// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.process;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.ProjectRule;
import org.SEAR.scene.ReadingTexts;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.simulator.Snapshot;
import org.SEAR.view.link.CameraFrame;
import org.SEAR.view.link.RunnerLink;
import org.junit.Rule;
import org.junit.Test;

/** A snapshot reaches the window's process with everything that the window draws. */
public class StateMessageTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static byte[] bytes(StateMessage message, StateMessage before, ReadingTexts texts) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        message.write(new DataOutputStream(bytes), before, texts);
        return bytes.toByteArray();
    }

    private static StateMessage message(byte[] bytes, StateMessage before) throws IOException {
        return StateMessage.read(new DataInputStream(new ByteArrayInputStream(bytes)), before);
    }

    @Test
    public void theReceivedSnapshotMakesTheSameBytes() throws Exception {
        new Box("crate", 1, 0.2, 0.2, 0.2, 0, 1, 2, 0, 0, 0);
        SEARrobot robot = new SEARrobot("rover");
        Dynamics drive = new Dynamics("drive", 3);
        robot.addComponent(drive);
        drive.setPorts("oiUart", "oiUser");
        robot.addComponent(new Distance("ping"));
        robot.addComponent(new Camera("eye"));
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            RunnerLink link = new RunnerLink(new SimulationRunner(world), () -> false);
            world.step();
            ReadingTexts texts = new ReadingTexts(world.getProject());
            byte[] bytes = bytes(StateMessage.of(link), null, texts);
            StateMessage received = message(bytes, null);
            assertArrayEquals(bytes, bytes(received, null, texts));
            Snapshot sent = link.snapshot();
            assertEquals(sent.step, received.snapshot.step);
            assertEquals(sent.robots.get(0).devices.toString(), received.snapshot.robots.get(0).devices.toString());
            assertEquals(List.of("ping", "eye"), List.copyOf(received.snapshot.readings.keySet()));
            assertEquals(sent.readings.get("ping").words("m"), received.snapshot.readings.get("ping").words("m"));
            assertArrayEquals(sent.readings.get("ping").beams(), received.snapshot.readings.get("ping").beams(), 0);
            link.close();
        }
    }

    @Test
    public void aPictureIsSentOnce() throws Exception {
        new Box("crate", 1, 0.2, 0.2, 0.2, 0, 1, 2, 0, 0, 0);
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            ReadingTexts texts = new ReadingTexts(world.getProject());
            CameraFrame picture = new CameraFrame("eye", "2 x 1", 2, 1, 0xff8000, 0x123456);
            StateMessage first = new StateMessage(world.snapshot(), false, 1, 2, true, picture);
            StateMessage second = new StateMessage(world.snapshot(), true, 0, 2, true, picture);
            StateMessage third = new StateMessage(world.snapshot(), true, 0, 2, true, null);
            StateMessage received = message(bytes(first, null, texts), null);
            assertEquals(0x123456, received.picture.pixel(1, 0));
            StateMessage again = message(bytes(second, first, texts), received);
            assertEquals(received.picture, again.picture);
            assertEquals(true, again.paused);
            assertEquals(null, message(bytes(third, second, texts), again).picture);
        }
    }

    @Test
    public void aHugePictureIsRefused() {
        byte[] huge = {2, 0, 0, 0, 0, (byte) 0xff, (byte) 0xff, 0, 1};
        String reason = assertThrows(IOException.class, () -> message(huge, null)).getMessage();
        assertEquals("a picture of 65535 x 1 was received, legal: at most 320 each way", reason);
    }
}
