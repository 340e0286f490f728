// SPDX-License-Identifier: Apache-2.0
package org.SEAR.architecture;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Dependencies between the compiled packages: no cycles, and the picture in the docs is up to date. */
@Category(Slow.class)
public class PackageGraphTest {
    private static final Path PICTURE = Path.of(System.getProperty("sear.root", "."), "docs/images/packages.svg");

    @Test
    public void packagesHaveNoCycles() throws Exception {
        PackageGraph graph = PackageGraph.ofPlugin();
        assertTrue(graph.uses().toString(), graph.below("org.myrobotlab.service").contains("org.myrobotlab.serial"));
        assertEquals(graph.uses().toString(), Collections.emptySet(), graph.circles());
    }

    @Test
    public void thePictureInTheDocsIsUpToDate() throws Exception {
        String picture = new PackagePicture(PackageGraph.ofPlugin()).svg();
        assertEquals("run ./gradlew packageGraph", picture, Files.readString(PICTURE, StandardCharsets.UTF_8));
    }

    @Test
    public void aCycleIsFound() {
        PackageGraph graph = new PackageGraph(
            Map.of("a", List.of("b"), "b", List.of("c"), "c", List.of("b", "d"), "e", List.of("a")));
        assertEquals(Set.of("b", "c"), graph.circles());
    }

    @Test
    public void transitiveArrowsAreLeftOut() {
        PackageGraph graph = new PackageGraph(Map.of("a", List.of("b", "c"), "b", List.of("c")));
        assertEquals(Set.of("b"), graph.direct("a"));
        assertEquals(2, graph.height("a"));
    }

    /** A descriptor, a constant and a generic argument each count as a use. */
    @Test
    public void namesAreReadFromAClassFile() throws Exception {
        try (java.io.InputStream in = PackageGraphTest.class.getResourceAsStream("PackagePicture.class")) {
            Set<String> names = ClassNames.in(in.readAllBytes());
            assertTrue(names.toString(), names.containsAll(
                Set.of("org/SEAR/architecture/PackageGraph", "java/util/Map", "java/util/Locale")));
        }
    }
}
