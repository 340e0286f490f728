// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.SerialObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.documents.DocBlock;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.project.xml.ObjectClasses;
import org.junit.Rule;
import org.junit.Test;

/** The page about the objects matches the program. */
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

    /** The page's script and the page's file make the same box. */
    @Test
    public void theFileOfThePageEqualsThatOfItsScript() throws Exception {
        String file = "environment/crate.xml";
        new Box("crate", 0.5, 0.4, 0.3, 2).move(1, 0.15, 0);
        assertTrue(DocBlock.of("docs/objects.md", "python").get(0)
            .contains("Box(\"crate\", 0.5, 0.4, 0.3, 2)\nbox.move(1, 0.15, 0)\n"));
        SearObject scripted = Project.read(project.folder()).getEnvironment().get(0);
        project.put(file, DocBlock.of("docs/objects.md", "xml").get(0));
        SearObject written = Project.read(project.folder()).getEnvironment().get(0);
        for (Parameter parameter : ParameterTable.of(Box.class).getParameters()) {
            assertEquals(parameter.getName(), parameter.get(scripted), parameter.get(written));
        }
    }

    /** Each call of the page exists with that number of arguments. */
    @Test
    public void everyCallOfThePageCanBeMade() throws Exception {
        int calls = 0;
        for (String block : DocBlock.of("docs/objects.md", "text")) {
            List<Class<?>> types = block.startsWith(".") ? List.of(Shape.class, SensorObject.class, SerialObject.class)
                : List.of(Class.forName("org.SEAR.POJOs." + block.substring(0, block.indexOf('('))));
            for (String line : block.split("\n")) {
                String name = line.replaceAll("^\\.|\\(.*", "");
                String arguments = line.replaceAll("^[^(]*\\(|\\)$", "");
                int count = arguments.isEmpty() ? 0 : arguments.split(", ").length;
                Stream<Executable> all = types.stream()
                    .flatMap(type -> Arrays.stream(line.startsWith(".") ? type.getMethods() : type.getConstructors()));
                assertTrue(types + " " + line, all.anyMatch(one -> one.getParameterCount() == count
                    && (one instanceof Constructor || one.getName().equals(name))));
                calls++;
            }
        }
        assertTrue(calls > 100);
    }

    @Test
    public void everyParameterOfEveryClassIsDescribed() {
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            assertFalse(type.getName(), ObjectDocs.description(type).isEmpty());
            for (Parameter parameter : ParameterTable.of(type).getParameters()) {
                assertFalse(type + " " + parameter.getName(), parameter.getDoc().isEmpty() || parameter.legal()
                    .isEmpty());
            }
        }
    }

    @Test
    public void theListingHasUnitLegalRangeAndDefault() {
        String listing = ObjectDocs.listing(LIDAR.class);
        assertTrue(listing, listing.contains("range              largest distance; a number from 0.01 to 10000 m; "
            + "default 8.191"));
    }
}
