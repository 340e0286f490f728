package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
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

/**
 * Files that are broken in one way each, with the message for each, in one table: {@code broken-files.txt}. A block starts with {@code # file}, then
 * the file's text, then a line {@code =>} for each problem, in order.
 */
public class BrokenFilesTest {
    private static final String GOOD_ROBOT = "<SEARrobot><name>r</name><component>d</component></SEARrobot>";
    private static final String GOOD_DYNAMICS = "<Dynamics><name>d</name><mass>3</mass></Dynamics>";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static final class Case {
        final String file;
        final StringBuilder text = new StringBuilder();
        final List<String> messages = new ArrayList<>();

        Case(String file) {
            this.file = file;
        }
    }

    private static List<Case> cases() throws IOException {
        List<Case> cases = new ArrayList<>();
        try (BufferedReader in = new BufferedReader(new InputStreamReader(BrokenFilesTest.class.getResourceAsStream("broken-files.txt"),
                StandardCharsets.UTF_8))) {
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                if (line.startsWith("# ")) {
                    cases.add(new Case(line.substring(2)));
                } else if (line.startsWith("=> ")) {
                    cases.get(cases.size() - 1).messages.add(line.substring(3));
                } else if (!line.isEmpty()) {
                    cases.get(cases.size() - 1).text.append(line).append('\n');
                }
            }
        }
        return cases;
    }

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
    public void eachIsReportedWithFileLineFieldValueAndWhatIsLegal() throws Exception {
        List<Case> cases = cases();
        assertTrue(cases.size() + " broken files", cases.size() >= 40);
        StringBuilder differences = new StringBuilder();
        for (Case broken : cases) {
            ProjectSwap.delete(project.folder());
            project.put("robot/r.xml", GOOD_ROBOT);
            project.put("robot/d.xml", GOOD_DYNAMICS);
            project.put("environment/other.xml", "<Box><name>other</name><length>1</length><width>1</width><height>1</height></Box>");
            assertEquals(List.of(), problems(project.folder()));
            project.put(broken.file, broken.text.toString());
            List<String> found = problems(project.folder());
            if (!matches(broken.messages, found)) {
                differences.append("\n# ").append(broken.file).append('\n').append(broken.text);
                found.forEach(m -> differences.append("=> ").append(m).append('\n'));
            }
        }
        assertEquals("", differences.toString());
    }

    /** A message of the table may end with ... */
    private static boolean matches(List<String> expected, List<String> found) {
        boolean same = expected.size() == found.size();
        for (int i = 0; same && i < expected.size(); i++) {
            String message = expected.get(i);
            same = message.endsWith("...") ? found.get(i).startsWith(message.substring(0, message.length() - 3)) : found.get(i).equals(message);
        }
        return same;
    }

    @Test
    public void allProblemsOfAProjectAreReportedAtOnce() throws Exception {
        project.put("environment/a.xml", "<Box>\n<name>a</name>\n<length>-1</length>\n<width>x</width>\n</Box>");
        project.put("environment/b.xml", "<Nonsense/>");
        project.put("robot/r.xml", "<SEARrobot>\n<name>r</name>\n<component>gone</component>\n</SEARrobot>");
        assertEquals(5, problems(project.folder()).size());
    }

    @Test
    public void aFileThatIsCutOffAnywhereIsSaidToEndInTheMiddle() {
        String whole = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- a box -->\n<Box>\n  <name>b &amp; c</name>\n  <length>1.5</length>\n"
            + "<!-- w --><width>1</width>\n<height>1</height>\n</Box>";
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
                assertTrue(cut + "\n" + said, said.contains("b.xml:" + line + ": the file ends in the middle") || said.contains("holds no object"));
            }
        }
    }

    @Test
    public void aFolderThatIsNotThereIsAClearProblem() {
        assertEquals(List.of(project.folder() + ": there is no such folder, legal: a SEARproject folder; creating an object makes one"),
            problems(project.folder()));
    }

    @Test(timeout = 60_000)
    public void hugeDeepAndExpandingFilesAreRefusedQuickly() throws Exception {
        project.put("environment/deep.xml", "<Box>".repeat(150000));
        project.put("environment/huge.xml", "<Box>" + " ".repeat(Xml.MAX_BYTES) + "</Box>");
        project.put("environment/laughs.xml", "<!DOCTYPE Box [<!ENTITY a \"aaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;\">]><Box><name>&b;</name></Box>");
        project.put("environment/many.xml", "<Box>" + "<x>a</x>".repeat(100000) + "</Box>");
        project.put("environment/wide.xml", "<Box " + "a=\"1\" ".repeat(1000) + "/>");
        Files.createSymbolicLink(project.folder().resolve("environment/endless.xml"), Path.of("/dev/zero"));
        List<String> messages = problems(project.folder());
        Map<String, String> expected = new LinkedHashMap<>();
        expected.put("deep", "nested more than 16 deep");
        expected.put("huge", "at most 1048576 bytes");
        expected.put("laughs", "document type");
        expected.put("endless", "neither a link nor a folder");
        expected.put("many", "<x> is there once too often");
        expected.forEach((file, text) -> {
            if (messages.stream().noneMatch(m -> m.startsWith("environment/" + file + ".xml") && m.contains(text))) {
                fail(file + ": " + messages.stream().filter(m -> m.contains(file)).findFirst().orElse("no message"));
            }
        });
        assertTrue(messages.size() <= 1000);
    }
}
