// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.Serial;

/**
 * The scripts' helper connects both a Roomba service that keeps its port and MyRobotLab Nixie's, which closes it
 * immediately.
 */
public class RoombaHelperTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", "."));
    private static final String[] SCRIPTS = {"resources/templates/userCode.py", "scripts/demo.py"};
    private static final Pattern HELPER = Pattern.compile("(?m)^def connectRoomba\\(.*\\n(?: +.*\\n)+");
    private static final String PORT = "/dev/helped";
    /** The connect methods of both MyRobotLabs, which use the service named serial. */
    private static final String ROOMBA = "class Roomba:\n    def __init__(self, keeps):\n        self.keeps = keeps\n"
        + "    def connect(self, port):\n        line = Runtime.start('serial', 'Serial')\n"
        + "        line.connect(port, 57600, 8, 1, 0)\n        if not self.keeps:\n            line.disconnect()\n";

    private Python python;

    @Before
    public void start() throws IOException {
        python = (Python) Runtime.start("python", "Python");
        Serial.connectVirtualUart(PORT);
    }

    @After
    public void release() {
        for (String name : new String[] {"serial", PORT.replace('/', '_') + ".UART", "python"}) {
            Runtime.releaseService(name);
        }
    }

    private static String helper() throws IOException {
        Set<String> helpers = new TreeSet<>();
        for (String script : SCRIPTS) {
            Matcher definition = HELPER.matcher(Files.readString(ROOT.resolve(script)));
            assertTrue(script, definition.find());
            helpers.add(definition.group());
        }
        assertEquals("the scripts have one and the same helper", 1, helpers.size());
        return helpers.iterator().next();
    }

    private void connects(String keeps) throws IOException {
        assertTrue(python.exec(ROOMBA + "\n" + helper() + "\nconnectRoomba(Roomba(" + keeps + "), '" + PORT + "')\n"));
        Serial serial = (Serial) Runtime.getService("serial");
        assertTrue("the port is open", serial.isConnected());
        assertEquals(PORT, serial.getPortName());
    }

    @Test
    public void theRoombaOfNixieThatClosesItsPort() throws Exception {
        connects("False");
    }

    @Test
    public void aRoombaThatKeepsItsPort() throws Exception {
        connects("True");
    }
}
