package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** What keeps a robot from driving is said at the start. */
public class StartChecksTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void aRobotWithoutGroundIsTold() throws Exception {
        Worlds.roomba("roomba", 1, 2, 0);
        assertEquals("[robot roomba has no ground below its start at x 1.00, y 0.10, z 2.00 and will fall:"
            + " Floor(\"floor\", 20, 20) makes one at height 0]", Worlds.start(project).snapshot().warnings.toString());
    }

    @Test
    public void aRobotWithoutWheelsIsTold() throws Exception {
        new Floor("floor", 10, 10);
        SEARrobot robot = new SEARrobot("post");
        robot.addComponent(new Dynamics("dynamics", 1, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.2, 0.2, 0.2, 1));
        assertEquals("[robot post has no wheels and can't drive: robot.addWheel(Wheel(...)) adds one]",
            Worlds.start(project).snapshot().warnings.toString());
    }

    @Test
    public void oneWithBothIsFine() throws Exception {
        new Floor("floor", 10, 10);
        Worlds.roomba("roomba", 0, 0, 0);
        assertEquals("[]", Worlds.start(project).snapshot().warnings.toString());
    }
}
