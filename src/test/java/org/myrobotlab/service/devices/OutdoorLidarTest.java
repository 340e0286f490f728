// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.ServiceFolder;

/** The LIDAR service reads each model that it supports, in a world with a wall that only outdoor scanners see. */
public class OutdoorLidarTest {
    private static final String PORT = "/dev/SEAR_LIDAR_01";
    private static final double WALL = 50;

    @Rule
    public final ServiceFolder folder = new ServiceFolder();
    private SEAR sear;

    private org.myrobotlab.service.LIDAR connect(String model) throws Exception {
        new Floor("floor", 20, 20);
        new Box("wall", 200, 1, 10, 0).move(0, 0, WALL + 0.5);
        new Box("post", 0.2, 0.2, 1, 0).move(-5, 0.5, 0);
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.1, 0, 0, 0, 0));
        robot.addWheel(new Wheel("left", 0.1, 0.03, 1, 0.2, 0, 0));
        robot.addWheel(new Wheel("right", 0.1, 0.03, 1, -0.2, 0, 0));
        robot.addWheel(new Wheel("front", 0.1, 0.03, 0, 0, 0, 0.2));
        robot.addWheel(new Wheel("rear", 0.1, 0.03, 0, 0, 0, -0.2));
        LIDAR scanner = new LIDAR("scanner");
        scanner.setModel(model);
        scanner.setPorts("/dev/my_Lidar01", PORT);
        scanner.move(0, 0.3, 0);
        robot.addComponent(scanner);
        sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        sear.simSleep(1);
        org.myrobotlab.service.LIDAR lidar = (org.myrobotlab.service.LIDAR) Runtime.start("reader", "LIDAR");
        lidar.setModel(model);
        lidar.connect(PORT);
        return lidar;
    }

    @Test
    public void anLms291SeesFarAndInCentimetres() throws Exception {
        readsWhatTheScriptCallAnswers("LMS291", "cm", 0.0051, 80);
    }

    @Test
    public void anLms221SeesFarAndInCentimetres() throws Exception {
        readsWhatTheScriptCallAnswers("LMS221", "cm", 0.0051, 80);
    }

    @Test
    public void anLms200SeesEightMetresInMillimetres() throws Exception {
        readsWhatTheScriptCallAnswers("LMS200", "mm", 0.00051, 8.182);
    }

    private void readsWhatTheScriptCallAnswers(String model, String unit, double tolerance, double farthest)
        throws Exception {
        org.myrobotlab.service.LIDAR lidar = connect(model);
        lidar.singleScan();
        sear.simSleep(3);
        assertNotNull(lidar.getLastScan());
        assertEquals(unit, lidar.getUnit());
        float[] expected = sear.getLidarResult("scanner");
        assertEquals(expected.length, lidar.getLastScan().metres.length);
        int seen = 0;
        for (int i = 0; i < expected.length; i++) {
            Double read = lidar.getLastScan().metres[i];
            if (expected[i] < farthest) {
                assertEquals("beam " + i, expected[i], read, tolerance);
                seen++;
            } else {
                assertNull("beam " + i + " " + read, read);
            }
        }
        assertEquals("beams to the wall or the post", farthest > WALL ? 104 : 3, seen, farthest > WALL ? 2 : 1);
    }
}
