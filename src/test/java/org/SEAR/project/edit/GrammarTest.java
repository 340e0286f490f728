// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.xml.ObjectClasses;
import org.junit.Rule;
import org.junit.Test;

/** Pages receive the whole grammar, and objects made from it alone are legal. */
public class GrammarTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @SuppressWarnings("unchecked")
    private static List<Map<String, Object>> parameters(Map<String, Object> of) {
        return (List<Map<String, Object>>) of.get("parameters");
    }

    @Test
    public void everyClassIsThereWithEveryParameter() {
        List<Class<? extends SearObject>> classes = ObjectClasses.find().all();
        List<Map<String, Object>> types = Grammar.types();
        assertEquals(classes.size(), types.size());
        for (int i = 0; i < classes.size(); i++) {
            Map<String, Object> type = types.get(i);
            assertEquals(classes.get(i).getSimpleName(), type.get("type"));
            assertFalse(type.get("type") + " says what it is", type.get("doc").toString().isEmpty());
            List<Parameter> known = ParameterTable.of(classes.get(i)).getParameters();
            assertEquals(known.stream().map(Parameter::getName).collect(Collectors.toList()),
                parameters(type).stream().map(one -> one.get("name")).collect(Collectors.toList()));
            for (int k = 0; k < known.size(); k++) {
                Map<String, Object> one = parameters(type).get(k);
                assertEquals(known.get(k).getDoc(), one.get("doc"));
                assertEquals(Grammar.unit(classes.get(i), known.get(k)), one.get("unit"));
                assertEquals(known.get(k).legal(), one.get("legal"));
                boolean group = known.get(k).getKind() == Parameter.Kind.GROUP;
                assertTrue(type.get("type") + "." + one.get("name"), !group || one.containsKey("parameters")
                    || one.get("name").equals("wheel"));
            }
        }
    }

    @Test
    public void everyClassCanBeAddedByTheGrammarAlone() throws Exception {
        ProjectEditor editor = new ProjectEditor(project.folder());
        assertEquals("create2", editor.apply(Map.of("do", "robot", "template", "create2")).object);
        for (Map<String, Object> type : Grammar.types()) {
            if (type.get("kind").equals("joint")) {
                editor.apply(Map.of("do", "add", "type", type.get("type"), "set", Map.of("second", "create2")));
                continue;
            }
            Map<String, Object> values = new HashMap<>();
            for (Map<String, Object> parameter : parameters(type)) {
                if (type.get("type").equals("ForceTorque")) {
                    continue;
                }
                if (Boolean.TRUE.equals(parameter.get("required")) && "".equals(parameter.get("initial"))
                    && !parameter.get("name").equals("name")) {
                    values.put((String) parameter.get("name"), "models/tree.j3o");
                }
            }
            boolean file = !values.isEmpty();
            boolean second = type.get("type").equals("Dynamics") || type.get("type").equals("ForceTorque");
            if (!file && !second) {
                Map<String, Object> edit = new HashMap<>(Map.of("do", "add", "type", type.get("type")));
                if (!Boolean.TRUE.equals(type.get("environment")) && Boolean.TRUE.equals(type.get("robot"))) {
                    edit.put("to", "create2");
                }
                if (type.get("type").equals("Motor")) {
                    edit.put("set", Map.of("wheel", "left"));
                }
                Outcome outcome = editor.apply(edit);
                assertEquals(type.get("type"), editor.object(outcome.object).get("type"));
            }
            assertTrue(type.get("type") + " has only files without an initial value", !file || values.keySet()
                .equals(Set.of("path")));
        }
    }

    @Test
    public void templatesAreTheRobotsThatScriptsMake() throws Exception {
        assertEquals(RobotTemplates.names().stream().sorted().collect(Collectors.toList()),
            Arrays.stream(Robots.class.getMethods()).filter(call -> call.getReturnType() == SEARrobot.class
                && call.getParameterCount() == 1).map(Method::getName).sorted().collect(Collectors.toList()));
        for (String template : RobotTemplates.names()) {
            Robots.class.getMethod(template, String.class).invoke(null, "rosie");
            Map<String, String> script = project.files();
            ProjectSwap.delete(project.folder());
            new ProjectEditor(project.folder()).apply(Map.of("do", "robot", "template", template, "name", "rosie"));
            Map<String, String> edited = project.files();
            edited.keySet().removeIf(file -> file.startsWith(".edits/"));
            assertEquals(template, script, edited);
            ProjectSwap.delete(project.folder());
        }
    }
}
