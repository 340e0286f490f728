// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.scripts;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.Test;

/** Scripts that users copy use only features that also work in the real MyRobotLab. */
public class ScriptTrapsTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", "."));
    private static final Pattern LISTENER =
        Pattern.compile("(\\w+)\\.addListener\\(\"(\\w+)\",\\s*[^,]+,\\s*\"(\\w+)\"");

    private static List<Path> scripts() throws IOException {
        List<Path> scripts = new ArrayList<>();
        for (String folder : new String[] {"scripts", "examples", "examples/drive", "resources/templates",
            "resources/resource/SEAR", "resources/resource/LIDAR", "resources/resource/GPS"}) {
            try (DirectoryStream<Path> files = Files.newDirectoryStream(ROOT.resolve(folder), "*.py")) {
                files.forEach(scripts::add);
            }
        }
        Collections.sort(scripts);
        return scripts;
    }

    /** Returns a script without its comments. */
    private static String code(Path script) throws IOException {
        return Files.readString(script).replaceAll("(?m)#.*$", "");
    }

    /**
     * Listings are printed in the dissertation: their waits pass simulated time in the embedded MyRobotLab and at real
     * time.
     */
    private static boolean isListing(Path script) {
        return script.getFileName().toString().startsWith("listing");
    }

    private static void assertNowhere(String what, String regex) throws IOException {
        List<String> found = new ArrayList<>();
        for (Path script : scripts()) {
            if (Pattern.compile(regex).matcher(code(script)).find()) {
                found.add(script + " has " + what);
            }
        }
        assertEquals(Collections.emptyList(), found);
    }

    @Test
    public void allTenListingsAndTheTemplatesAreThere() throws IOException {
        Set<String> names = new HashSet<>();
        scripts().forEach(script -> names.add(script.getFileName().toString()));
        for (int i = 1; i <= 10; i++) {
            String name = String.format("listing%02d.py", i);
            assertTrue(name, names.contains(name));
            String head = Files.readAllLines(ROOT.resolve("scripts").resolve(name)).get(0);
            assertTrue(head, head.startsWith("# Listing " + i + " of the dissertation"));
        }
        assertTrue(names.containsAll(Arrays.asList("demo.py", "controller.py", "userCode.py")));
    }

    @Test
    public void callbacksTakeTheValueAsTheirArgument() throws IOException {
        for (Path script : scripts()) {
            Matcher listener = LISTENER.matcher(code(script));
            while (listener.find()) {
                Pattern definition = Pattern.compile("def " + listener.group(3) + "\\(\\w+\\):");
                assertTrue(script + ": " + listener.group(3), definition.matcher(code(script)).find());
            }
        }
    }

    @Test
    public void noFunctionIsTheCallbackOfTwoPublishers() throws IOException {
        for (Path script : scripts()) {
            Map<String, String> publishers = new HashMap<>();
            Matcher listener = LISTENER.matcher(code(script));
            while (listener.find()) {
                String publisher = listener.group(1) + "." + listener.group(2);
                String other = publishers.put(listener.group(3), publisher);
                assertTrue(script + ": " + listener.group(3), other == null || other.equals(publisher));
            }
        }
    }

    @Test
    public void formerPublishersAreNotUsed() throws IOException {
        assertNowhere("publishByte", "publishByte\\b");
        assertNowhere("a msg_ variable", "\\bmsg_\\w+");
    }

    @Test
    public void serviceVariablesComeFromTheCallThatStartsThem() throws IOException {
        assertNowhere("a start whose result is dropped", "(?m)^\\s*Runtime\\.(start|create|createAndStart)\\(");
        for (Path script : scripts()) {
            assertTrue(script + " waits by the computer's clock", isListing(script)
                || !Pattern.compile("(?<![.\\w])sleep\\(|roomba\\.sleep\\(|time\\.sleep").matcher(code(script)).find());
        }
    }

    @Test
    public void theRoombaIsConnectedByTheHelper() throws IOException {
        for (Path script : scripts()) {
            if (code(script).contains("\"Roomba\"") && !isListing(script)) {
                assertTrue(script.toString(), code(script).contains("def connectRoomba(roomba, port):"));
                assertTrue(script.toString(), code(script).contains("connectRoomba(roomba, "));
            }
        }
    }

    @Test
    public void nothingIsWrittenToSerialThatMyRobotLabRefuses() throws IOException {
        assertNowhere("a list or a float written to a port", "\\.write\\((\\[|\\d+\\.\\d)");
    }
}
