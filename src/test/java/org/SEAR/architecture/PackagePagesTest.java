// SPDX-License-Identifier: Apache-2.0
package org.SEAR.architecture;

import static org.junit.Assert.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** The uses that each package-info states match the compiled classes. */
@Category(Slow.class)
public class PackagePagesTest {
    private static final Path SOURCES = Path.of(System.getProperty("sear.root", "."), "src/main/java");
    /** A sentence; a dot within a name is not followed by a blank. */
    private static final Pattern USES = Pattern.compile("\\bUses (?:[^.]|\\.(?! |$))*\\.");
    private static final Pattern LINK = Pattern.compile("\\{@link ([\\w.]+)\\}");

    @Test
    public void eachPageNamesThePackagesThatItsOwnUses() throws Exception {
        PackageGraph graph = PackageGraph.ofPlugin();
        SortedMap<String, SortedSet<String>> said = new TreeMap<>();
        SortedMap<String, SortedSet<String>> used = new TreeMap<>();
        for (String name : graph.uses().keySet()) {
            said.put(name, said(Files.readString(SOURCES.resolve(name.replace('.', '/'))
                .resolve("package-info.java"))));
            used.put(name, graph.direct(name));
        }
        assertEquals("after \"Uses\" in package-info.java", lines(used), lines(said));
    }

    /** One package per line, so that a difference shows all errors. */
    private static String lines(SortedMap<String, SortedSet<String>> packages) {
        return packages.entrySet().stream().map(Object::toString).collect(Collectors.joining("\n"));
    }

    @Test
    public void theSentenceIsFoundAmongOthers() {
        assertEquals(new TreeSet<>(java.util.Set.of("org.a.b", "org.c")),
            said("/**\n * Of {@link org.d}. Uses {@link org.a.b}\n * and {@link org.c}, and what these use. Not {@link "
                + "org.e}.\n */\npackage x;"));
    }

    /** Returns the packages in the one sentence that begins with "Uses". */
    private static SortedSet<String> said(String page) {
        Matcher sentence = USES.matcher(page.replaceAll("\\s+\\*?\\s*", " "));
        SortedSet<String> names = new TreeSet<>();
        int sentences = 0;
        while (sentence.find()) {
            sentences++;
            LINK.matcher(sentence.group()).results().forEach(link -> names.add(link.group(1)));
        }
        assertEquals("sentences that begin with \"Uses\" in " + page, 1, sentences);
        return names;
    }
}
