// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.SEAR.Slow;
import org.junit.BeforeClass;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** The page of calls matches the services' javadoc, which has no gaps. */
@Category(Slow.class)
public class ScriptDocsTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", "."));

    private static ScriptDocs docs;

    @BeforeClass
    public static void readJavadoc() throws IOException {
        docs = new ScriptDocs(ROOT);
    }

    @Test
    public void thePageIsUpToDate() throws IOException {
        assertEquals("run gradle scriptDocs", docs.page(), Files.readString(ROOT.resolve("docs/scripting.md")));
    }

    @Test
    public void thePictureIsUpToDate() throws IOException {
        assertEquals("run gradle scriptDocs", FramesPicture.svg(),
            Files.readString(ROOT.resolve("docs/images/frames.svg")));
    }

    @Test
    public void everyCallHasItsParametersAndAnExample() {
        assertEquals(List.of(), docs.gaps());
    }

    /** Each example calls its method on the variable of its service. */
    @Test
    public void everyExampleCallsItsMethod() {
        List<String> wrong = new ArrayList<>();
        Map<String, String> variables = new TreeMap<>(Map.of("SEAR", "sear", "LIDAR", "lidar", "GPS", "gps"));
        variables.forEach((service, variable) -> docs.calls(service).forEach(call -> {
            String called = call.name.startsWith("publish") ? variable + ".addListener(\"" + call.name + "\"" : variable
                + "." + call.name + "(";
            if (!call.example.contains(called)) {
                wrong.add(service + "." + call.signature() + ": " + call.example);
            }
        }));
        assertEquals(List.of(), wrong);
    }

    @Test
    public void callsForPanelsAndMyRobotLabAreLeftOut() throws IOException {
        String page = docs.page();
        assertTrue(page.contains("### driveStraight(speed)\n"));
        assertTrue(page.contains("- `radius`: metres, + to the left; infinity = straight, 0 = in place to the left\n"));
        for (String other : new String[] {"### getPreview(", "### onBytes(", "### startService("}) {
            assertTrue(other, !page.contains(other));
        }
    }
}
