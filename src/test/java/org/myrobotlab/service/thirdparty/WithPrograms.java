// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;

/**
 * Base of these tests: a project in a temporary folder, a SEAR service that simulates it in real time, and third-party
 * programs at its ports.
 */
abstract class WithPrograms {
    /** Folder of programs that use third-party drivers, and of their configurations. */
    static final Path SCRIPTS = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath()
        .resolve("src/test/drivers");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    final Programs programs = new Programs(folder);
    /** Set by {@link #simulate}. */
    SEAR sear;

    @Before
    public final void keepTheProjectInTheFolder() {
        System.setProperty("sear.project", inFolder("SEARproject"));
        System.setProperty("sear.headless", "true");
    }

    @After
    public final void stop() {
        programs.end();
        if (sear != null) {
            sear.stopSimulation();
            Runtime.releaseService("sear");
        }
        System.clearProperty("sear.project");
        System.clearProperty("sear.headless");
    }

    /** Returns the path of a name in the temporary folder. */
    final String inFolder(String name) {
        return folder.getRoot().toPath().resolve(name).toString();
    }

    /** Makes a floor with objects ahead, to the left and to the right of its middle. */
    static void room() {
        new Floor("floor", 20, 20);
        new Box("ahead", 6, 0.2, 1, 0).move(0, 0.5, 3);
        new Box("left", 1, 1, 1, 0).move(3, 0.5, 1);
        new Cylinder("pillar", 0.2, 1, 0).move(-2, 0.5, 1.5);
    }

    /** Starts the simulation and runs it for a second. */
    final void simulate() {
        sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        sear.simSleep(1);
    }

    /** Returns a Python program of {@link #SCRIPTS} or elsewhere with access to the third-party drivers. */
    static ProcessBuilder python(String script, Object... arguments) {
        List<String> command = new ArrayList<>(List.of("python3", "-u", SCRIPTS.resolve(script).toString()));
        Arrays.stream(arguments).map(Object::toString).forEach(command::add);
        return withDrivers(new ProcessBuilder(command));
    }

    /** Adds the third-party drivers to a command's Python path. */
    static ProcessBuilder withDrivers(ProcessBuilder builder) {
        builder.environment().put("PYTHONPATH", System.getProperty("sear.drivers"));
        return builder;
    }

    /**
     * Writes a configuration of MRPT's rawlog-grabber that logs in the temporary folder.
     * @param file of {@link #SCRIPTS}
     * @param log the name of the log; {@link Programs#grabScans} looks for {@code log}
     * @param replaced pairs of old and new text
     */
    final Path grabber(String file, String log, String... replaced) throws IOException {
        String text = Files.readString(SCRIPTS.resolve(file)).replace("@OUTPUT@", inFolder(log));
        for (int i = 0; i < replaced.length; i += 2) {
            assertTrue(replaced[i], text.contains(replaced[i]));
            text = text.replace(replaced[i], replaced[i + 1]);
        }
        return Files.writeString(folder.newFile().toPath(), text);
    }

    /** Returns the number in a field of gpsd's JSON. */
    static double number(String json, String field) {
        return Double.parseDouble(json.replaceAll(".*\"" + field + "\":(-?[0-9.]+).*", "$1"));
    }
}
