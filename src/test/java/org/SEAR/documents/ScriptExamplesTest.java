// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.SEAR.Slow;
import org.SEAR.cli.ScriptProcess;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** Every example of docs/scripting.md runs after the page's preparation. */
@Category(Slow.class)
public class ScriptExamplesTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", "."));
    /** Number of blocks with more than one example: preparation, callbacks, driving. */
    private static final int LONG_BLOCKS = 3;
    private static final List<String> WHILE_STOPPED = Arrays.asList("startSimulation", "setGroundVisible", "newProject",
        "loadProject", "importRobot", "importEnvironment", "importUrdf", "copyTemplate");

    /** Calls that need a vehicle; their examples run with the first block of its page. */
    private static final List<String> VEHICLES = Arrays.asList("setMotorPower", "setMotorSpeed", "getMotorSpeed",
        "getEncoder", "setServo", "getServo", "setLed", "getLed", "setSteering");

    /** Calls that need a joint with a motor. */
    private static final List<String> JOINTS = Arrays.asList("setJointPosition", "setJointSpeed", "setJointPower",
        "getJoint", "getJointForce");

    /** Calls that need a camera; their examples run with the world of its page. */
    private static final List<String> CAMERAS = Arrays.asList("getImage", "getPixels", "getDepth", "getTemperatures",
        "getPointCloud", "getBlobs", "saveImage", "exportCamera", "stopExportCamera");

    /** Restores the state that the page assumes before each example. */
    private static final String READY = String.join("\n",
        "import os",
        "def ready(running):",
        "    special = any(os.path.exists('SEARproject/' + one + '.xml') for one in ('robot/car', 'robot/thermal',"
            + " 'environment/door_hinge'))",
        "    if sear.isSimulating() and (not running or special): sear.stopSimulation()",
        "    if running and not sear.isSimulating():",
        "        if 'gpsUnit1.xml' not in ''.join(os.listdir('SEARproject/robot') if "
        + "os.path.exists('SEARproject/robot') else []):", "            sear.loadProject('examples/sensors.sear')",
        "        sear.startSimulation()",
        "    if not running and not os.path.exists('SEARproject'): sear.loadProject('examples/sensors.sear')",
        "def vehicle():",
        "    if os.path.exists('SEARproject/robot/car.xml'): return",
        "    if sear.isSimulating(): sear.stopSimulation()",
        "    sear.newProject()",
        "    exec VEHICLE in globals()",
        "def joints():",
        "    if os.path.exists('SEARproject/environment/door_hinge.xml'): return",
        "    if sear.isSimulating(): sear.stopSimulation()",
        "    sear.newProject()",
        "    from org.SEAR.POJOs import Box, Hinge",
        "    Hinge('door_hinge', None, Box('door', 0.8, 0.04, 2, 20, 0.4, 1, 0), 0, 1, 0).setMotor(50, 90)",
        "    sear.startSimulation()",
        "def cameras():",
        "    if os.path.exists('SEARproject/robot/thermal.xml'): return",
        "    if sear.isSimulating(): sear.stopSimulation()",
        "    sear.loadProject('examples/ball.sear')",
        "    sear.startSimulation()",
        "    sear.simSleep(0.5)",
        "def connected(service, port, baud):",
        "    if sear.isPaused(): sear.resume()",
        "    if not service.isConnected(): service.connect(port, baud)",
        "");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Test
    public void everyExampleRuns() throws Exception {
        List<String> blocks = DocBlock.of("docs/scripting.md", "python");
        StringBuilder script = new StringBuilder(String.join("\n", blocks.subList(0, LONG_BLOCKS))).append('\n')
            .append("VEHICLE = '''").append(DocBlock.of("docs/vehicles.md", "python").get(0)).append("'''\n")
            .append(READY);
        int count = 0;
        ScriptDocs docs = new ScriptDocs(ROOT);
        for (String service : ScriptDocs.SERVICES) {
            if (!service.equals("SEAR")) {
                script.append("ready(False)\nfor port in sear.getExports(): sear.endExport(port)\n");
            }
            for (ScriptCall call : docs.calls(service)) {
                script.append(VEHICLES.contains(call.name) ? "vehicle()\n" : CAMERAS.contains(call.name) ? "cameras()\n"
                    : JOINTS.contains(call.name) ? "joints()\n"
                    : "ready(" + (WHILE_STOPPED.contains(call.name) ? "False" : "True") + ")\n");
                if (service.equals("LIDAR") && !call.name.equals("connect")) {
                    script.append("connected(lidar, '/dev/SEAR_LIDAR_01', 38400)\n");
                } else if (service.equals("GPS") && !call.name.equals("connect")) {
                    script.append("connected(gps, '/dev/SEAR_GPS_01', 38400)\n");
                }
                script.append(call.example).append(
                    "\nsear.simSleep(0.1) if sear.isSimulating() and not sear.isPaused() else None\n");
                script.append("print 'example ").append(++count).append(" done'\n");
            }
            script.append(service.equals("LIDAR") ? "lidar.singleScan()\nsear.simSleep(30)\n" : "");
        }
        script.append("print 'all done'\n");
        assertEquals("all blocks of the page are examples", LONG_BLOCKS + count, blocks.size());
        Path drive = Files.createDirectories(folder.getRoot().toPath().resolve("examples/drive"));
        Files.copy(ROOT.resolve("examples/drive/maze_solver.py"), drive.resolve("maze_solver.py"));
        Files.copy(ROOT.resolve("examples/arm.urdf"), folder.getRoot().toPath().resolve("arm.urdf"));
        Path file = folder.getRoot().toPath().resolve("examples.py");
        Files.writeString(file, script);
        String text = ScriptProcess.run(folder.getRoot().toPath(), file);
        assertTrue(text, text.contains("\nall done"));
        assertEquals(text, count, text.split("example \\d+ done", -1).length - 1);
        assertTrue("a callback was called:\n" + text, Pattern.compile("\\d+ beams, the nearest at \\d+ mm")
            .matcher(text).find());
        assertTrue(text, Pattern.compile("frontPing at [0-9.]+ s: ").matcher(text).find());
        assertTrue(text, Pattern.compile("33\\.6\\d{5}, -80\\.8\\d{5} degrees, 182").matcher(text).find());
        List<String> errors = Arrays.stream(text.split("\n")).filter(line -> line.matches(".*(Traceback|\\[?ERROR).*"))
            .collect(Collectors.toList());
        assertEquals(text, List.of(), errors);
    }
}
