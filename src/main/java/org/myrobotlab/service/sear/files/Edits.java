// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import java.io.IOException;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.Project;
import org.SEAR.project.edit.Grammar;
import org.SEAR.project.edit.Outcome;
import org.SEAR.project.edit.ProjectEditor;
import org.SEAR.project.edit.RobotTemplates;
import org.SEAR.project.problems.FileReasons;
import org.SEAR.project.problems.ProjectException;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * Edits of the current project for scripts and panels: those of {@link ProjectEditor}, and {@code undo} and
 * {@code redo}. A move also moves the object in a running simulation, of whatever service, because all have the one
 * project. Any thread.
 *
 * <pre>
 * {"done": true, "page": "7f3a" (copied from the edit), "words": "move crate" (empty if nothing changed),
 *  "object": "crate" or null, "files": ["environment/crate.xml"], "note": "..." or null, "undo": "move crate" or null,
 * "redo": null, "problems": []} {"done": false, "page": "7f3a", "problems": [{"file", "line", "field", "value",
 * "legal"}],
 *  "reason": ".." (if there are no problems)}
 * </pre>
 */
public final class Edits {
    private static final String UNDO = "undo";
    private static final String REDO = "redo";

    private static ProjectEditor editor() {
        return new ProjectEditor(Projects.folder());
    }

    /** Returns the objects that can be created: {@code types}, see {@link Grammar}, and {@code templates} of robots. */
    public static Map<String, Object> grammar() {
        Map<String, Object> grammar = new LinkedHashMap<>();
        grammar.put("types", Grammar.types());
        grammar.put("templates", RobotTemplates.names());
        return grammar;
    }

    /**
     * Returns an object as its file describes it, see {@link ProjectEditor#object}.
     *
     * @return with {@code gone} if no readable object has this name
     */
    public static Map<String, Object> object(String name) throws IOException {
        try {
            return editor().object(name);
        } catch (ProjectException e) {
            Map<String, Object> gone = new LinkedHashMap<>();
            gone.put("object", name);
            gone.put("gone", e.getMessage());
            return gone;
        }
    }

    /**
     * Reverts an edit that a killed program left incomplete, before its files are read.
     *
     * @param notices takes the reason if that fails
     */
    public static void mend(Consumer<String> notices) {
        try {
            editor().state();
        } catch (IOException | ProjectException e) {
            notices.accept(FileReasons.of(e));
        }
    }

    /** Returns what undo and redo would change now. */
    public static Map<String, Object> state() throws IOException, ProjectException {
        return answer(editor().state(), null, null);
    }

    /**
     * Applies an edit.
     *
     * @throws ProjectException with all its problems; nothing has changed then
     */
    public Map<String, Object> apply(Map<?, ?> asked) throws IOException, ProjectException, InterruptedException {
        Map<?, ?> edit = given(asked);
        Object kind = edit.get("do");
        SimulationSession session = SimulationControl.sessionOfAny();
        Outcome outcome = UNDO.equals(kind) ? editor().undo() : REDO.equals(kind) ? editor().redo()
            : editor().apply(session == null ? edit : GroundSnap.of(edit, session));
        return answer(outcome, edit.get("page"), note(outcome, session, UNDO.equals(kind)));
    }

    /** Applies a panel's edit; the answer contains its problems. */
    public Map<String, Object> attempt(Map<?, ?> asked) throws InterruptedException {
        Map<?, ?> edit = given(asked);
        try {
            return apply(edit);
        } catch (ProjectException e) {
            return refusal(edit, e.getProblems(), null);
        } catch (IOException | IllegalStateException | IllegalArgumentException e) {
            return refusal(edit, Collections.emptyList(), FileReasons.of(e));
        }
    }

    /** Treats null as an empty edit. */
    private static Map<?, ?> given(Map<?, ?> edit) {
        return edit == null ? Map.of() : edit;
    }

    private static Map<String, Object> refusal(Map<?, ?> edit, List<?> problems, String reason) {
        Map<String, Object> answer = new LinkedHashMap<>();
        answer.put("done", false);
        answer.put("page", edit.get("page"));
        answer.put("problems", problems);
        answer.put("reason", reason);
        return answer;
    }

    private static Map<String, Object> answer(Outcome outcome, Object page, String note) {
        Map<String, Object> answer = new LinkedHashMap<>();
        answer.put("done", true);
        answer.put("page", page);
        answer.put("words", outcome.words);
        answer.put("object", outcome.object);
        answer.put("files", outcome.files);
        answer.put("note", note);
        answer.put(UNDO, outcome.undo);
        answer.put(REDO, outcome.redo);
        answer.put("problems", Collections.emptyList());
        return answer;
    }

    /** Moves objects in the running simulation. Returns a note about the edit; null for none. */
    private static String note(Outcome outcome, SimulationSession session, boolean back) throws InterruptedException {
        if (session == null || outcome.files.isEmpty()) {
            return outcome.note;
        }
        boolean all = !outcome.more;
        try {
            Project now = outcome.moved.isEmpty() ? null : Project.read(Projects.folder());
            for (String name : outcome.moved) {
                all &= session.place(whole(now, name), now, back);
            }
        } catch (ProjectException | IllegalArgumentException e) {
            all = false;
        }
        String later = all ? null : "a simulation runs: "
            + (outcome.moved.isEmpty() ? "this" : "everything except moves of its objects")
            + " takes effect at its next start";
        return outcome.note == null || later == null ? (outcome.note == null ? later : outcome.note) : outcome.note
            + "; " + later;
    }

    /** Returns the robot that has the component, else the name itself. */
    private static String whole(Project project, String name) {
        return project.getRobots().stream().filter(robot -> robot.getComponentNames().contains(name))
            .map(SEARrobot::getName).findFirst().orElse(name);
    }
}
