// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.junit.rules.ExternalResource;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.sear.RecordingHost;
import org.myrobotlab.service.sear.readings.ScriptCameras;
import org.myrobotlab.service.sear.run.SimulationControl;

/** A project with a camera of each kind, called color, depth and infrared, and its simulation. */
final class CameraWorld extends ExternalResource {
    static final int WIDTH = 64;
    static final int HEIGHT = 48;
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(120);

    final TemporaryFolder folder = new TemporaryFolder();
    final RecordingHost host = new RecordingHost();
    SimulationControl control;
    ScriptCameras cameras;

    @Override
    protected void before() throws Throwable {
        folder.create();
        Path project = folder.getRoot().toPath().resolve("SEARproject");
        System.setProperty("sear.headless", "true");
        System.setProperty("sear.project", project.toString());
        control = new SimulationControl(host, () -> project);
        cameras = new ScriptCameras(control);
        control.scriptSession().open();
        new Floor("floor", 20, 20);
        Box red = new Box("red", 0.6, 0.2, 0.6, 0);
        red.setColor("red");
        red.setTemperature(50);
        red.move(0.3, 0.4, 2.1);
        SEARrobot robot = new SEARrobot("rover");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.05, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.4, 0.4, 0.1, 4));
        for (String kind : new String[] {Camera.COLOR, Camera.DEPTH, Camera.INFRARED}) {
            Camera camera = new Camera(kind, 0, 0.3, 0);
            camera.setKind(kind);
            camera.setSize(WIDTH, HEIGHT);
            robot.addComponent(camera);
        }
        Camera fast = new Camera("fast", 0, 0.3, 0);
        fast.setRate(60);
        fast.setShotNoise(200, 5);
        robot.addComponent(fast);
    }

    /** Starts the simulation and clears the warnings about the robot without wheels. */
    void start() throws Exception {
        control.start(false);
        host.warnings.clear();
    }

    /** Starts with paused time, so that the cameras always have the same pictures. */
    void startPaused() throws Exception {
        start();
        control.session().pause();
    }

    static void until(String what, BooleanSupplier condition) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE;
        while (!condition.getAsBoolean()) {
            assertTrue(what, System.nanoTime() < end);
            TimeUnit.MILLISECONDS.sleep(10);
        }
    }

    @Override
    protected void after() {
        control.stop();
        control.scriptSession().close();
        System.clearProperty("sear.project");
        System.clearProperty("sear.headless");
        folder.delete();
    }
}
