// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.junit.Before;
import org.junit.Rule;

/** A new project and its editor for each test. */
public abstract class EditedProject {
    @Rule
    public final ProjectRule project = new ProjectRule();
    ProjectEditor editor;

    @Before
    public void open() {
        editor = new ProjectEditor(project.folder());
    }

    Outcome edit(Object... pairs) throws IOException, ProjectException {
        return editor.apply(map(pairs));
    }

    static Map<String, Object> map(Object... pairs) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int i = 0; i < pairs.length; i += 2) {
            map.put((String) pairs[i], pairs[i + 1]);
        }
        return map;
    }

    /** Returns the files of objects. */
    Map<String, String> objects() throws IOException {
        Map<String, String> files = project.files();
        files.keySet().removeIf(file -> file.startsWith(".edits/"));
        return files;
    }

    Object value(String object, String parameter) throws Exception {
        return ((Map<?, ?>) editor.object(object).get("values")).get(parameter);
    }
}
