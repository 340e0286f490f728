package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Parameter;
import org.SEAR.POJOs.ParameterTable;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.xml.ObjectClasses;
import org.junit.Rule;
import org.junit.Test;

/** The page about the objects says what the program does. */
public class ObjectDocsTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static String text(String file) throws Exception {
        Path path = Paths.get(System.getProperty("sear.root", "."), file);
        return new String(Files.readAllBytes(path), StandardCharsets.UTF_8);
    }

    @Test
    public void thePageIsUpToDate() throws Exception {
        assertEquals("run gradle objectDocs", ObjectDocs.page(), text("docs/objects.md"));
    }

    @Test
    public void theExampleFileOfEachPageIsRead() throws Exception {
        for (String page : new String[] {"docs/objects.md", "docs/projects.md"}) {
            for (String block : text(page).split("```xml\n")) {
                if (block.startsWith("<")) {
                    String xml = block.substring(0, block.indexOf("```"));
                    String name = xml.replaceAll("(?s).*?<name>(.*?)</name>.*", "$1");
                    String folder = xml.startsWith("<Beam>") ? "beams/" : xml.startsWith("<Box>") ? "environment/" : "robot/";
                    project.put(folder + name + ".xml", xml);
                }
            }
        }
        assertFalse(Project.read(project.folder()).getEnvironment().isEmpty());
        assertFalse(Project.read(project.folder()).getRobots().isEmpty());
    }

    @Test
    public void everyParameterOfEveryClassIsDescribed() {
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            assertFalse(type.getName(), ObjectDocs.description(type).isEmpty());
            for (Parameter parameter : ParameterTable.of(type).getParameters()) {
                assertFalse(type + " " + parameter.getName(), parameter.getDoc().isEmpty() || parameter.legal().isEmpty());
            }
        }
    }

    @Test
    public void theListingHasUnitLegalRangeAndDefault() {
        String listing = ObjectDocs.listing(LIDAR.class);
        assertTrue(listing, listing.contains("range              farthest distance; a number from 0.01 to 10000 m; default 8.191"));
    }
}
