// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Box;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.xml.Xml;
import org.junit.Rule;
import org.junit.Test;

/** Each broken file is reported with its message, and so are files too large or too broken for the table. */
public class BrokenFilesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private List<String> problems(Path folder) {
        try {
            Project.read(folder);
        } catch (ProjectException e) {
            List<String> messages = new ArrayList<>();
            e.getProblems().forEach(p -> messages.add(p.toString()));
            return messages;
        }
        return List.of();
    }

    @Test
    public void eachIsReportedWithFileLineFieldValueAndLegalRange() throws Exception {
        List<BrokenFiles> cases = BrokenFiles.all();
        assertTrue(cases.size() + " broken files", cases.size() >= 40);
        StringBuilder differences = new StringBuilder();
        for (BrokenFiles broken : cases) {
            ProjectSwap.delete(project.folder());
            for (Map.Entry<String, String> good : BrokenFiles.GOOD.entrySet()) {
                project.put(good.getKey(), good.getValue());
            }
            assertEquals(List.of(), problems(project.folder()));
            project.put(broken.file, broken.text.toString());
            List<String> found = problems(project.folder());
            if (!broken.matches(found)) {
                differences.append("\n# ").append(broken.file).append('\n').append(broken.text);
                found.forEach(m -> differences.append("=> ").append(m).append('\n'));
            }
        }
        assertEquals("", differences.toString());
    }

    @Test
    public void allProblemsOfAProjectAreReportedTogether() throws Exception {
        project.put("environment/a.xml", "<Box>\n<name>a</name>\n<length>-1</length>\n<width>x</width>\n</Box>");
        project.put("environment/b.xml", "<Nonsense/>");
        project.put("robot/r.xml", "<SEARrobot>\n<name>r</name>\n<component>gone</component>\n</SEARrobot>");
        assertEquals(5, problems(project.folder()).size());
    }

    @Test
    public void aTruncatedFileIsReportedAsSuch() {
        String whole = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- a box -->\n<Box>\n  <name>b &amp; c</name>\n  "
            + "<length>1.5</length>\n<!-- w --><width>1</width>\n<height>1</height>\n</Box>";
        for (int length = 1; length < whole.length(); length++) {
            String cut = whole.substring(0, length);
            ProblemList problems = new ProblemList();
            Xml.parse(cut.getBytes(StandardCharsets.UTF_8), "b.xml", Map.of("Box", Box.class), problems);
            int line = (int) cut.chars().filter(c -> c == '\n').count() + 1;
            try {
                problems.throwIfAny();
                fail(cut);
            } catch (ProjectException e) {
                String said = e.getMessage();
                assertTrue(cut + "\n" + said, said.contains("b.xml:" + line + ": the file ends in the middle")
                    || said.contains("holds no object"));
            }
        }
    }

    @Test
    public void aMissingFolderIsAClearProblem() {
        assertEquals(List.of(project.folder() + ": there is no such folder, legal: a SEARproject folder; creating an "
            + "object makes one"), problems(project.folder()));
    }

    @Test(timeout = 60_000)
    public void hugeDeepAndExpandingFilesAreRefusedQuickly() throws Exception {
        project.put("environment/deep.xml", "<Box>".repeat(150000));
        project.put("environment/huge.xml", "<Box>" + " ".repeat(Xml.MAX_BYTES) + "</Box>");
        project.put("environment/laughs.xml", "<!DOCTYPE Box [<!ENTITY a \"aaaaaaaa\"><!ENTITY b "
            + "\"&a;&a;&a;&a;&a;\">]><Box><name>&b;</name></Box>");
        project.put("environment/many.xml", "<Box>" + "<x>a</x>".repeat(100000) + "</Box>");
        project.put("environment/wide.xml", "<Box " + "a=\"1\" ".repeat(1000) + "/>");
        Files.createSymbolicLink(project.folder().resolve("environment/endless.xml"), Path.of("/dev/zero"));
        List<String> messages = problems(project.folder());
        Map<String, String> expected = new LinkedHashMap<>();
        expected.put("deep", "nested more than 16 deep");
        expected.put("huge", "at most 1048576 bytes");
        expected.put("laughs", "document type");
        expected.put("endless", "neither a link nor a folder");
        expected.put("many", "<x> occurs once too often");
        expected.forEach((file, text) -> {
            if (messages.stream().noneMatch(m -> m.startsWith("environment/" + file + ".xml") && m.contains(text))) {
                fail(file + ": " + messages.stream().filter(m -> m.contains(file)).findFirst().orElse("no message"));
            }
        });
        assertTrue(messages.size() <= 1000);
    }
}
