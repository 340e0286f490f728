// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.CameraImage;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Over 100 s cameras take pictures, and records keep them, at the rates asked for. */
public class RecordRatesTest {
    private static final double SECONDS = 100;
    private static final double[] RATES = {0.7, 7, 10, 25, 29.97, 40, 59, 60};

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Project cameras() throws Exception {
        SEARrobot robot = Robots.create("rover", "/dev/uart", "/dev/user");
        for (double rate : RATES) {
            Camera camera = new Camera("eye " + rate, 0, 0.3, 0.2);
            camera.setKind(Camera.DEPTH);
            camera.setSize(1, 1);
            camera.setRate(rate);
            robot.addComponent(camera);
        }
        return Project.read(project.folder());
    }

    @Test
    public void pictures() throws Exception {
        Project read = cameras();
        for (double kept : new double[] {5, 7, 24, 30}) {
            Path file = project.getRoot().toPath().resolve("run.searlog");
            Map<Double, Integer> taken = new LinkedHashMap<>();
            try (Simulation world = Simulation.of(read, 7)) {
                Recorder recorder = Recorder.begin(world, file, Recorder.LIMIT, kept, said -> { });
                Map<Double, CameraImage> last = new LinkedHashMap<>();
                for (int step = 1; step <= Math.round(SECONDS / Simulation.STEP); step++) {
                    world.step();
                    for (double rate : RATES) {
                        CameraImage image = (CameraImage) world.read("eye " + rate);
                        if (step * Simulation.STEP >= 1 / rate && image != last.put(rate, image)) {
                            taken.merge(rate, 1, Integer::sum);
                            double due = taken.get(rate) / rate;
                            assertTrue(rate + " Hz: " + image.getTime() + " for " + due,
                                image.getTime() > due - 1e-6 && image.getTime() < due + Simulation.STEP + 1e-6);
                        }
                    }
                }
                recorder.end();
            }
            RecordPictures pictures = RecordPictures.of(RunRecord.open(file));
            for (double rate : RATES) {
                assertEquals(rate + " Hz", Math.floor(SECONDS * rate + 1e-6), taken.get(rate), 0);
                double most = SECONDS * Math.min(kept, rate);
                assertEquals(kept + " of " + rate + " Hz", most, pictures.count("eye " + rate), 1 + most / 1000);
            }
        }
    }
}
