// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.junit.runners.Parameterized;

/**
 * MyRobotLab's own services at the simulated ports. Each script of {@code src/realTest/python/mrl_services} compares
 * one service with the simulation and raises on a difference.
 */
@RunWith(Parameterized.class)
public class MrlServicesTest extends InRealMrl {
    private static final Path SCRIPTS = ROOT.resolve("src/realTest/python");

    /**
     * Errors that MyRobotLab always logs: its Arduino for a board that has not yet identified itself when the port
     * opens, its Pir at each start, and any service that calls a function of a script from a message.
     */
    private static final Pattern ALWAYS_SAID = Pattern.compile(
        "board info is null|pir error pin control not set|Method Cache look up Failed! org.myrobotlab.service.Python");

    private final String name;

    public MrlServicesTest(String name) {
        this.name = name;
    }

    @Parameterized.Parameters(name = "{0}")
    public static List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(SCRIPTS.resolve("mrl_services"))) {
            return files.map(file -> file.getFileName().toString()).sorted().collect(Collectors.toList());
        }
    }

    @Test
    public void theServiceWorksAtTheSimulatedPort() throws Exception {
        int before = mrl.log().length();
        assertEquals("", mrl.python("ROOT = " + RealMrl.literal(ROOT.toString()),
            Files.readString(SCRIPTS.resolve("world.py")),
            Files.readString(SCRIPTS.resolve("mrl_services").resolve(name))));
        String told = mrl.log().substring(before).lines()
            .filter(line -> line.contains(" ERROR ") && !ALWAYS_SAID.matcher(line).find())
            .collect(Collectors.joining("\n"));
        assertEquals("what its log complains of", "", told);
    }
}
