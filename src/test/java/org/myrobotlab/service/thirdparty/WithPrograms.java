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

/** What all these tests have: a project in a temporary folder, a SEAR service that simulates it in real time, and programs of others at its ports. */
abstract class WithPrograms {
    /** Programs that use drivers by others, and configurations of such. */
    static final Path SCRIPTS = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath().resolve("src/test/drivers");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    final Programs programs = new Programs(folder);
    /** From {@link #simulate} on. */
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

    /** The path of what has that name in the temporary folder. */
    final String inFolder(String name) {
        return folder.getRoot().toPath().resolve(name).toString();
    }

    /** A floor with things ahead, to the left and to the right of its middle. */
    static void room() {
        new Floor("floor", 20, 20);
        new Box("ahead", 6, 0.2, 1, 0).move(0, 0.5, 3);
        new Box("left", 1, 1, 1, 0).move(3, 0.5, 1);
        new Cylinder("pillar", 0.2, 1, 0).move(-2, 0.5, 1.5);
    }

    /** Simulates what was made, and gives it a second. */
    final void simulate() {
        sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        sear.simSleep(1);
    }

    /** A program of {@link #SCRIPTS}, or elsewhere, that finds the drivers by others. */
    static ProcessBuilder python(String script, Object... arguments) {
        List<String> command = new ArrayList<>(List.of("python3", "-u", SCRIPTS.resolve(script).toString()));
        Arrays.stream(arguments).map(Object::toString).forEach(command::add);
        return withDrivers(new ProcessBuilder(command));
    }

    /** The same command, for which Python finds the drivers by others. */
    static ProcessBuilder withDrivers(ProcessBuilder builder) {
        builder.environment().put("PYTHONPATH", System.getProperty("sear.drivers"));
        return builder;
    }

    /**
     * A configuration of MRPT's rawlog-grabber that logs in the temporary folder.
     *
     * @param file of {@link #SCRIPTS}
     * @param log the name of what it logs; {@link Programs#grabScans} looks for {@code log}
     * @param replaced texts in it, each before what stands there instead
     */
    final Path grabber(String file, String log, String... replaced) throws IOException {
        String text = Files.readString(SCRIPTS.resolve(file)).replace("@OUTPUT@", inFolder(log));
        for (int i = 0; i < replaced.length; i += 2) {
            assertTrue(replaced[i], text.contains(replaced[i]));
            text = text.replace(replaced[i], replaced[i + 1]);
        }
        return Files.writeString(folder.newFile().toPath(), text);
    }

    /** The number that a field of gpsd's JSON has. */
    static double number(String json, String field) {
        return Double.parseDouble(json.replaceAll(".*\"" + field + "\":(-?[0-9.]+).*", "$1"));
    }
}
