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
 * Edits of the present project for scripts and panels: what {@link ProjectEditor} takes, and {@code undo} and {@code redo}. What is moved while a
 * simulation runs moves there, too. Any thread.
 *
 * <pre>
 * {"done": true, "page": "7f3a" (as it stood in the edit), "words": "move crate" (empty if it was so already), "object": "crate" or null,
 *  "files": ["environment/crate.xml"], "note": "..." or null, "undo": "move crate" or null, "redo": null, "problems": []}
 * {"done": false, "page": "7f3a", "problems": [{"file", "line", "field", "value", "legal"}], "reason": ".." (where there are no problems)}
 * </pre>
 */
public final class Edits {
    private static final String UNDO = "undo";
    private static final String REDO = "redo";

    private final SimulationControl control;

    /** @param control of the simulation in which things move */
    public Edits(SimulationControl control) {
        this.control = control;
    }

    private static ProjectEditor editor() {
        return new ProjectEditor(Projects.folder());
    }

    /** What may be made: {@code types} as {@link Grammar} tells them, and {@code templates} of robots. */
    public static Map<String, Object> grammar() {
        Map<String, Object> grammar = new LinkedHashMap<>();
        grammar.put("types", Grammar.types());
        grammar.put("templates", RobotTemplates.names());
        return grammar;
    }

    /**
     * An object as it stands in its file, see {@link ProjectEditor#object}.
     *
     * @return with {@code gone} if there is none of that name that can be read
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
     * Takes back the edit in the middle of which a program was killed, before anybody reads its files.
     *
     * @param notices get what hinders that
     */
    public static void mend(Consumer<String> notices) {
        try {
            editor().state();
        } catch (IOException | ProjectException e) {
            notices.accept(FileReasons.of(e));
        }
    }

    /** What undo and redo would do now. */
    public static Map<String, Object> state() throws IOException, ProjectException {
        return answer(editor().state(), null, null);
    }

    /**
     * Does an edit.
     *
     * @throws ProjectException with all that is wrong with it; nothing has changed then
     */
    public Map<String, Object> apply(Map<?, ?> asked) throws IOException, ProjectException, InterruptedException {
        Map<?, ?> edit = given(asked);
        Object kind = edit.get("do");
        SimulationSession session = control.sessionOrNull();
        Outcome outcome = UNDO.equals(kind) ? editor().undo() : REDO.equals(kind) ? editor().redo()
            : editor().apply(session == null ? edit : GroundSnap.of(edit, session));
        return answer(outcome, edit.get("page"), note(outcome, session, UNDO.equals(kind)));
    }

    /** Does an edit for a panel: what is wrong stands in the answer. */
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

    /** None is an edit of which everything is missing. */
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

    /** Moves what was moved where a simulation runs. What else there is to say of an edit; null for nothing. */
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
        String later = all ? null : "a simulation runs: " + (outcome.moved.isEmpty() ? "this" : "what is no place of a thing it knows")
            + " takes effect at its next start";
        return outcome.note == null || later == null ? (outcome.note == null ? later : outcome.note) : outcome.note + "; " + later;
    }

    /** The robot whose component it is, else the name itself. */
    private static String whole(Project project, String name) {
        return project.getRobots().stream().filter(robot -> robot.getComponentNames().contains(name)).map(SEARrobot::getName).findFirst()
            .orElse(name);
    }
}
