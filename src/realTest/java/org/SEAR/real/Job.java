// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

final class Job {
    private static final Path ROOT = InRealMrl.ROOT;
    private static final String WHAT_IS_THERE = "sear.startSimulation()\nsear.simSleep(1)\nfor part in "
        + "sear.getSensorNames():\n    print part, ['%.4f' % value for value in sear.getPose(part)]\n";
    private static final String LISTEN = "sear.simSleep(3)\n";
    private static final String ROOM = "from org.SEAR.POJOs import Accelerometer, Box, Compass, Distance, "
        + "Floor, Gyroscope\nFloor('floor', 50, 50)\nBox('wall', 4, 0.1, 1, 0).move(0, 0.5, -1.5)\nexecfile("
        + script("scripts/listing02.py") + ", globals())\n"
        + "for (name, x) in (('testPing1', 0.05), ('MyNewestSONAR', -0.05)):\n"
        + "    ping = Distance(name, 'laser')\n    ping.move(x, 0.1, 0.15)\n    robot.addComponent(ping)\n"
        + "for sensor in (Accelerometer('accel'), Gyroscope('gyro1'), Compass('comp1')): robot.addComponent(sensor)\n"
        + "sear.copyTemplate('controller.py', 'SEARproject')\n";
    private static final Pattern SERVICE = Pattern.compile("Runtime\\.\\w+\\(\"(\\w+)\", ?\"SEAR\"\\)");

    private final String name;
    private final boolean byTheClock;
    private final String text;

    /**
     * @param name for the report
     * @param sear the name of its SEAR service
     * @param byTheClock whether the script waits by sleep(), which passes no simulated time in lock-step
     * @param body lines of Python
     */
    private Job(String name, String sear, boolean byTheClock, String body) {
        this.name = name;
        this.byTheClock = byTheClock;
        text = "sear = Runtime.start('" + sear + "', 'SEAR')\nkept = sear.newProject()\n" + body
            + "sear = Runtime.getService('" + sear + "')\nif sear.isSimulating(): sear.stopSimulation()\n";
    }

    /** Returns every script; each listing of the dissertation follows the listings that it builds on. */
    static List<Job> all() throws IOException {
        List<Job> jobs = new ArrayList<>();
        for (int[] numbers : new int[][] {{1, 2, 3}, {1, 4, 5}, {1, 4, 6}, {1, 7, 8}, {9}}) {
            StringBuilder body = new StringBuilder();
            Arrays.stream(numbers).forEach(
                number -> body.append(execute(String.format("scripts/listing%02d.py", number))));
            jobs.add(new Job("listings " + Arrays.toString(numbers), "SEAR", true, body.toString()));
        }
        for (Path file : python("scripts", "examples", "examples/drive")) {
            String path = ROOT.relativize(file).toString();
            if (!path.startsWith("scripts/listing")) {
                boolean builds = path.startsWith("examples/") && !path.startsWith("examples/drive");
                jobs.add(new Job(path, serviceOf(file), false, execute(path) + (builds ? WHAT_IS_THERE : "")));
            }
        }
        for (String template : new String[] {"arduino", "userCode"}) {
            Path file = ROOT.resolve("resources/templates/" + template + ".py");
            jobs.add(new Job(template + ".py", serviceOf(file), false, (template.equals("userCode") ? ROOM : "")
                + "sear.copyTemplate('" + template + ".py', 'SEARproject')\nexecfile('SEARproject/" + template
                    + ".py', globals())\n"));
        }
        jobs.add(new Job("SEAR.py", "sear", false, execute("resources/resource/SEAR/SEAR.py")));
        for (String type : new String[] {"LIDAR", "GPS"}) {
            jobs.add(new Job(type + ".py", "sear", false, "sear.loadProject(" + script("examples/sensors.sear")
                + ")\nsear.startSimulation()\n"
                + "sear.simSleep(1)\n" + execute("resources/resource/" + type + "/" + type + ".py") + LISTEN));
        }
        return jobs;
    }

    private static List<Path> python(String... folders) throws IOException {
        List<Path> files = new ArrayList<>();
        for (String folder : folders) {
            try (Stream<Path> here = Files.list(ROOT.resolve(folder))) {
                files.addAll(here.filter(file -> file.toString().endsWith(".py")).sorted()
                    .collect(Collectors.toList()));
            }
        }
        return files;
    }

    private static String serviceOf(Path file) throws IOException {
        Matcher service = SERVICE.matcher(Files.readString(file));
        return service.find() ? service.group(1) : "sear";
    }

    private static String script(String path) {
        return RealMrl.literal(ROOT.resolve(path).toString());
    }

    private static String execute(String path) {
        return "__file__ = " + script(path) + "\nexecfile(__file__, globals())\n";
    }

    boolean isByTheClock() {
        return byTheClock;
    }

    /** Returns the text for the embedded MyRobotLab. */
    String alone() {
        return text;
    }

    /** Returns the text for one session of a real MyRobotLab. */
    String inSession() {
        return text.replaceFirst("\n", "\nsear.setLockStep(" + (byTheClock ? "False" : "True") + ")\nsear.setSpeed("
            + (byTheClock ? "1" : "float('inf')") + ")\n");
    }

    @Override
    public String toString() {
        return name;
    }
}
