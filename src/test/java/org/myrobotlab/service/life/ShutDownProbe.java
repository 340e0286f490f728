// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.life;

import static org.junit.Assert.assertNull;

import java.io.IOException;
import java.nio.file.Paths;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.TestWorld;

/** A MyRobotLab with a simulation and a server for other programs; it shuts down when its standard input ends. */
final class ShutDownProbe {
    /** Text before the number of the server's port. */
    static final String LISTENS = "listens at ";
    static final String SHUTS_DOWN = "shuts down";

    private ShutDownProbe() {
    }

    /**
     * The real MyRobotLab ends the process in its shutdown. With the embedded one the process ends when no thread
     * remains.
     * @param arguments a folder for the project
     */
    public static void main(String[] arguments) throws IOException {
        TestWorld.build(Paths.get(arguments[0]));
        SEAR sear = (SEAR) Runtime.start("life", "SEAR");
        sear.startSimulation();
        System.out.println(LISTENS + sear.exportTcp(TestWorld.ROOMBA_PORT, 0));
        System.in.readAllBytes();
        System.out.println(SHUTS_DOWN);
        Runtime.shutdown();
        LifeTest.assertNothingIsLeft();
        assertNull(Runtime.getService("life"));
    }
}
