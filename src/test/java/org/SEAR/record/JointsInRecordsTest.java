// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.SEAR.POJOs.BallJoint;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.Slider;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Records have the readings of joints beside those of sensors. */
public class JointsInRecordsTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void positionSpeedAndEffortAreRecordedAndARerunRepeatsThem() throws Exception {
        Box door = new Box("door", 0.8, 0.04, 2, 20, 0.4, 1, 0);
        Hinge hinge = new Hinge("hinge", null, door, 0, 1, 0);
        hinge.setMotor(50, 90);
        new Slider("lift", null, new Box("load", 0.1, 0.1, 0.1, 1, 2, 5, 0), 2, 5, 0).setMotor(20, 1);
        new BallJoint("hook", null, new Box("bob", 0.1, 0.1, 0.1, 1, 4, 5, 0), 4, 5, 0);
        Robots.rover("rover").addComponent(new Compass("compass"));
        Path file = project.getRoot().toPath().resolve("run.searlog");
        double[] last;
        try (Simulation world = Simulation.of(Project.read(project.folder()), 7)) {
            Recorder recorder = Recorder.begin(world, file, Recorder.LIMIT, said -> { });
            world.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_SPEED, "hinge", 45));
            for (int i = 0; i < 120; i++) {
                world.step();
            }
            last = world.read("hinge").numbers();
            assertEquals("0.000 m, 0.000 m/s, 9.81 N", world.read("lift").words(world.getUnit("lift")));
            recorder.end();
        }
        RunRecord record = RunRecord.open(file);
        List<String> names = List.of("hinge.position", "hinge.speed", "hinge.effort", "lift.effort", "compass");
        assertTrue(Series.names(record.getHeader()).containsAll(names));
        assertTrue("a ball joint has no position", Series.names(record.getHeader()).stream().noneMatch(one ->
            one.startsWith("hook.")));
        Series series = Series.of(record, names, 1000);
        int end = series.times.length - 1;
        for (int i = 0; i < last.length; i++) {
            assertEquals(last[i], series.values[i][end], 0);
        }
        assertEquals(45, series.values[1][end], 0.1);
        assertEquals("the motor holds the load", 9.81, series.values[3][end], 0.02);
        assertTrue(series.csv().startsWith("time (s),hinge.position,hinge.speed,hinge.effort,lift.effort,"));
        assertTrue(Rerun.of(record, Project.read(project.folder())).same);
    }
}
