// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;

/** The classes that the developers' pages name exist. */
public class NamesInPagesTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", "."));
    private static final List<String> PAGES = Arrays.asList("CONTRIBUTING.md", "docs/architecture.md", "docs/panels.md",
        "docs/add-a-sensor.md", "docs/physics.md");
    private static final Pattern CODE = Pattern.compile("(?s)```.*?```|`([^`]+)`");
    /** Optional packages, a class, optional members. */
    private static final Pattern NAME =
        Pattern.compile("((?:[a-z]\\w*\\.)*)([A-Z]\\w*[a-z]\\w*)(?:\\.\\w+)*(?:\\(.*\\))?");
    private static final Pattern FILE = Pattern.compile(".*\\.(js|java|py|xml|html|css|sear)");
    private static final Pattern IMPORT = Pattern.compile("(?m)^import (?:static )?(?:\\w+\\.)*(\\w+);$");
    private static final Pattern DECLARED = Pattern.compile("\\b(?:class|interface|enum) (\\w+)");
    /** Package with a name that begins like a class. */
    private static final Pattern OBJECTS = Pattern.compile("^POJOs(\\.|$)");

    @Test
    public void eachNamedClassExists() throws IOException {
        List<Path> sources = sources();
        List<String> wrong = new ArrayList<>();
        Set<String> known = known(sources);
        int seen = 0;
        for (String page : PAGES) {
            for (MatchResult code : CODE.matcher(Files.readString(ROOT.resolve(page))).results()
                .collect(Collectors.toList())) {
                String said = code.group(1) == null ? "" : OBJECTS.matcher(code.group(1)).replaceFirst("");
                Matcher name = NAME.matcher(said);
                if (name.matches() && !FILE.matcher(said).matches()) {
                    seen++;
                    String file = "/" + name.group(1).replace('.', '/') + name.group(2) + ".java";
                    boolean there = name.group(1).isEmpty() ? known.contains(name.group(2))
                        : sources.stream().anyMatch(source -> source.toString().replace('\\', '/').endsWith(file));
                    if (!there) {
                        wrong.add(page + ": " + code.group());
                    }
                }
            }
        }
        assertTrue("names: " + seen, seen > PAGES.size());
        assertEquals("classes that are not there", Collections.emptyList(), wrong);
    }

    @Test
    public void missingClassesAreFound() throws IOException {
        Set<String> known = known(sources());
        assertTrue(known.containsAll(Arrays.asList("NamesInPagesTest", "SEARrobot", "ServiceLoader")));
        assertFalse(known.contains("Mt3301" + "Type"));
    }

    /** Returns the names of all classes of the project, nested ones included, and of their imports. */
    private static Set<String> known(List<Path> sources) throws IOException {
        Set<String> names = new HashSet<>();
        for (Path source : sources) {
            String text = Files.readString(source);
            for (Pattern pattern : Arrays.asList(IMPORT, DECLARED)) {
                pattern.matcher(text).results().forEach(found -> names.add(found.group(1)));
            }
        }
        return names;
    }

    private static List<Path> sources() throws IOException {
        try (Stream<Path> files = Files.walk(ROOT.resolve("src"))) {
            return files.filter(file -> file.toString().endsWith(".java")).collect(Collectors.toList());
        }
    }
}
