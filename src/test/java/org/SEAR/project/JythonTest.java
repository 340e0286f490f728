// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.lang.reflect.Executable;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.ScriptText;
import org.SEAR.project.xml.ObjectClasses;
import org.junit.Rule;
import org.junit.Test;
import org.python.core.PySystemState;
import org.python.util.PythonInterpreter;

/** Every constructor and method, called from a Jython script; the expected XML is stored beside it. */
public class JythonTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static Path resource(String name) throws Exception {
        return Paths.get(JythonTest.class.getResource(name).toURI());
    }

    @Test
    public void everyConstructorAndMethodGivesItsXml() throws Exception {
        ExampleMaker.run(resource("every_constructor.py"));
        StringBuilder all = new StringBuilder();
        for (Map.Entry<String, String> file : project.files().entrySet()) {
            all.append("# ").append(file.getKey()).append('\n').append(file.getValue());
        }
        Path made = Paths.get(System.getProperty("sear.root", "."), "build/every_constructor.txt");
        Files.createDirectories(made.getParent());
        Files.write(made, all.toString().getBytes(StandardCharsets.UTF_8));
        String expected = new String(Files.readAllBytes(resource("every_constructor.txt")), StandardCharsets.UTF_8);
        assertEquals("see " + made, expected, all.toString());
        Project read = Project.read(project.folder());
        assertEquals(56, read.getEnvironment().size());
        assertEquals(5, read.getWarnings().size());
        SEARrobot robot = read.getRobots().get(0);
        assertEquals(11, robot.getWheels().size());
        assertEquals(73, robot.getComponents().size());
    }

    /** Relative paths of a script refer to its os.getcwd(). */
    @Test
    public void relativePathsFollowChdir() {
        String folder = project.folder().toAbsolutePath().getParent().toString().replace('\\', '/');
        try (PythonInterpreter python = new PythonInterpreter(null, new PySystemState())) {
            python.exec("import os\nfrom org.SEAR.grammar import ScriptText\nbefore = "
                + "ScriptText.path('a.png')\nos.chdir('" + folder + "')\n"
                + "after = ScriptText.path('a.png')\nabsolute = ScriptText.path('" + folder + "/b.png')\n");
            assertEquals(Path.of("a.png"), python.get("before", Path.class));
            assertEquals(Path.of(folder, "a.png"), python.get("after", Path.class));
            assertEquals(Path.of(folder, "b.png"), python.get("absolute", Path.class));
        }
        assertEquals("outside scripts", Path.of("a.png"), ScriptText.path("a.png"));
    }

    @Test
    public void theScriptCallsEverySetter() throws Exception {
        String script = new String(Files.readAllBytes(resource("every_constructor.py")), StandardCharsets.UTF_8);
        List<String> missing = new ArrayList<>();
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            for (Executable method : type.getMethods()) {
                boolean reading = method.getName().matches("(get|has|is|to)[A-Z].*")
                    || method.getDeclaringClass() == Object.class;
                if (!reading && !Modifier.isStatic(method.getModifiers())
                    && !script.contains("." + method.getName() + "(")) {
                    missing.add(type.getSimpleName() + "." + method.getName());
                }
            }
            assertTrue(type.getSimpleName(), script.contains(type.getSimpleName()));
        }
        assertEquals(List.of(), missing);
    }
}
