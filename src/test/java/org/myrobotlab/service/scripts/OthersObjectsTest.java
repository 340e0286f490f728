// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.scripts;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/** When a script starts its own world, one line names the project's objects that it did not make. */
public class OthersObjectsTest {
    private static final String BUILD = "from org.SEAR.POJOs import Box\nsear = Runtime.start('othersSear', 'SEAR')\n";
    private static final String START = "Box('mine', 1, 1, 1, 0).move(9, 0.5, 9)\nsear.startSimulation()\n";
    private static final String NAMED = "in the project, but not made by this script: \"floor\", \"wall\", "
        + "\"roomba\" (from";

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Python python;
    private Heard heard;

    @Before
    public void start() {
        TestWorld.build(temporary.getRoot().toPath());
        python = (Python) Runtime.start("othersPython", "Python");
        SEAR sear = (SEAR) Runtime.start("othersSear", "SEAR");
        heard = (Heard) Runtime.start("othersHeard", "Heard");
        sear.addListener("publishStatus", "othersHeard", "onStatus");
    }

    @Test
    public void theyAreNamedInOneLine() throws Exception {
        python.execAndWait(BUILD + START);
        assertTrue(heard.getStatuses().toString(), heard.awaitStatus(NAMED));
    }

    @Test
    public void notAfterNewProject() throws Exception {
        python.execAndWait(BUILD + "sear.newProject()\n" + START + "sear.info('that was all')\n");
        assertTrue(heard.getStatuses().toString(), heard.awaitStatus("that was all"));
        assertFalse(heard.getStatuses().toString(), heard.getStatuses().toString().contains("not made by this script"));
    }

    /** For example a robot's Dynamics, whose name the robot of the next project also has. */
    @Test
    public void namesOfAnotherProjectDoNotCount() throws Exception {
        String other = "'" + temporary.getRoot().toPath().resolve("other.sear") + "'";
        python.execAndWait(BUILD + "from org.SEAR.POJOs import Robots\nsear.newProject()\nRobots.create2('first')\n"
            + "sear.saveProject(" + other
            + ")\nsear.loadProject(" + other + ")\nRobots.create2('second')\nsear.info('that was all')\n");
        assertTrue(heard.getStatuses().toString(), heard.awaitStatus("that was all"));
        assertFalse(heard.getStatuses().toString(), heard.getStatuses().toString().contains("made already"));
    }
}
