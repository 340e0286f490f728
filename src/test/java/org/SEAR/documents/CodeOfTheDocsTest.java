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
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.cli.ScriptProcess;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The Python of README and docs runs: page by page, its blocks one after the other, in a project with a floor. */
public class CodeOfTheDocsTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final Pattern BLOCK = Pattern.compile("```python\n(.*?)```", Pattern.DOTALL);
    /** Calls as objects.md lists them, which are not code: {@code Box(name, length, width, height)}. */
    private static final Pattern LIST = Pattern.compile("(\\w+\\(.*\\)\n)*(\\.\\w+\\(.*\\)\n)*");
    /** Pages whose code other tests run, in the surroundings that it needs. */
    private static final Map<String, String> BY_OTHERS = Map.of("README.md", "ReadmeTest", "docs/scripting.md", "ScriptExamplesTest",
        "docs/add-a-sensor.md", "AddASensorTest", "docs/other-programs.md", "ReadmeTest, ExportsTest, ThirdPartyDriversTest");
    private static final String BEFORE = "from org.SEAR.POJOs import Floor\nsear = Runtime.start('sear', 'SEAR')\n"
        + "floor = Floor('ground', 9, 9)\n";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private static Map<String, List<String>> pages() throws IOException {
        Map<String, List<String>> pages = new TreeMap<>();
        List<Path> files = new ArrayList<>(List.of(ROOT.resolve("README.md")));
        try (Stream<Path> docs = Files.list(ROOT.resolve("docs"))) {
            docs.filter(page -> page.toString().endsWith(".md")).forEach(files::add);
        }
        for (Path file : files) {
            Matcher blocks = BLOCK.matcher(Files.readString(file));
            List<String> code = blocks.results().map(found -> found.group(1)).filter(text -> !LIST.matcher(text).matches())
                .collect(Collectors.toList());
            if (!code.isEmpty()) {
                pages.put(ROOT.relativize(file).toString().replace('\\', '/'), code);
            }
        }
        return pages;
    }

    @Test
    public void everyPageRunsHereOrInATestOfItsOwn() throws Exception {
        Map<String, List<String>> pages = pages();
        assertTrue(pages.keySet().toString(), pages.keySet().containsAll(BY_OTHERS.keySet()));
        pages.keySet().removeAll(BY_OTHERS.keySet());
        assertEquals("[docs/objects.md, docs/physics.md, docs/projects.md, docs/sensors.md, docs/window.md]", pages.keySet().toString());
        for (Map.Entry<String, List<String>> page : pages.entrySet()) {
            Path own = folder.newFolder(Path.of(page.getKey()).getFileName().toString()).toPath();
            Path script = own.resolve("page.py");
            Files.writeString(script, BEFORE + String.join("\n", page.getValue()) + "\nprint 'to the end'\n");
            assertTrue(page.getKey(), ScriptProcess.run(own, script).contains("to the end"));
        }
    }
}
