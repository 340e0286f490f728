// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** A real MyRobotLab starts with SEAR installed. */
public class StartTest extends InRealMrl {
    @Test
    public void theServicesStartAndSimulatedTimePasses() throws Exception {
        assertEquals("1.0\n", mrl.python("sear = Runtime.start('sear', 'SEAR')",
            "lidar = Runtime.start('lidar', 'LIDAR')", "gps = Runtime.start('gps', 'GPS')", "sear.setLockStep(True)",
            "sear.loadProject(" + RealMrl.literal(ROOT + "/examples/office.sear") + ")", "sear.startSimulation()",
            "before = sear.getTime()", "sear.simSleep(1)", "print round(sear.getTime() - before, 3)"));
    }
}
