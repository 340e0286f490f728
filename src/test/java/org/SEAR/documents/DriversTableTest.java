// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Properties;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;

/** Each row of the table of drivers names its test, and the version that the tests install. */
public class DriversTableTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String HEADING = "## Which drivers were tried?";
    private static final Pattern TEST = Pattern.compile("`(\\w+Test)\\.(\\w+)`");
    private static final Pattern PACKAGE = Pattern.compile("([\\w-]+) \\(PyPI\\)");
    private static final int COLUMNS = 5;

    private static List<String[]> rows() throws Exception {
        String page = Files.readString(ROOT.resolve("docs/other-programs.md"));
        String section = page.substring(page.indexOf(HEADING) + HEADING.length()).split("\n## ")[0];
        return section.lines().filter(line -> line.startsWith("| ") && !line.startsWith("| device "))
            .map(line -> line.substring(1, line.length() - 1).split("\\|")).collect(Collectors.toList());
    }

    @Test
    public void eachRowNamesAnExistingTestOrByHand() throws Exception {
        assertTrue(rows().size() > 5);
        for (String[] row : rows()) {
            String text = String.join("|", row);
            assertEquals(text, COLUMNS, row.length);
            Matcher test = TEST.matcher(row[COLUMNS - 1]);
            if (!row[COLUMNS - 1].contains("by hand")) {
                assertTrue(text, test.find());
                Class<?> type = test(test.group(1));
                assertNotNull(text, type.getMethod(test.group(2)).getAnnotation(Test.class));
            }
        }
    }

    private static Class<?> test(String name) throws Exception {
        Path sources = ROOT.resolve("src/test/java");
        try (Stream<Path> files = Files.walk(sources)) {
            String file = files.filter(one -> one.endsWith(name + ".java")).findFirst()
                .orElseThrow(() -> new AssertionError("no test " + name)).toString();
            String inside = file.substring(sources.toString().length() + 1);
            return Class.forName(inside.replace(".java", "").replace(File.separatorChar, '.'));
        }
    }

    @Test
    public void versionsOfPythonPackagesAreThoseOfTheBuild() throws Exception {
        Properties versions = new Properties();
        versions.load(Files.newBufferedReader(ROOT.resolve("gradle.properties")));
        for (String[] row : rows()) {
            Matcher name = PACKAGE.matcher(row[1]);
            if (name.find()) {
                String key = name.group(1).replaceAll("-.*", "") + "Version";
                assertEquals(String.join("|", row), versions.getProperty(key), row[2].trim());
            }
        }
    }
}
