// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import org.SEAR.lessons.LessonRun;
import org.myrobotlab.embedded.python.PythonEngine;
import org.myrobotlab.embedded.python.ScriptResult;

/** The check.py of a lesson, in an interpreter separate from the pupils' scripts. Any thread, one at a time. */
final class LessonCheck {
    private static final double MAX_SECONDS = 3600;

    private final Lesson lesson;
    private final PythonEngine engine;
    private final double seconds;

    /** @throws IOException if the check has an error or lacks a part */
    LessonCheck(Lesson lesson) throws IOException {
        this.lesson = lesson;
        engine = new PythonEngine("check of " + lesson.check(), new ByteArrayOutputStream(), System.err);
        ScriptResult result = engine.runFile(lesson.check().toString());
        if (result.getTraceback() != null) {
            throw new IOException(lesson.check() + " has an error:\n" + result.getTraceback());
        }
        Object limit = engine.get("SECONDS");
        if (!engine.has("check") || !(limit instanceof Number)) {
            throw new IOException(lesson.check() + " lacks "
                + (engine.has("check") ? "SECONDS, the simulated time that counts" : "the function check(run)"));
        }
        seconds = ((Number) limit).doubleValue();
        if (!(seconds > 0 && seconds <= MAX_SECONDS)) {
            throw new IOException(lesson.check() + ": SECONDS is " + seconds + ", legal: above 0 to " + MAX_SECONDS);
        }
    }

    /** Returns the simulated time that counts, s. */
    double getSeconds() {
        return seconds;
    }

    /**
     * Runs the check on a run.
     *
     * @throws IOException with the error that the check raises
     */
    synchronized void look(LessonRun run) throws IOException {
        ScriptResult result = engine.call("check", run);
        if (result.getTraceback() != null) {
            throw new IOException(lesson.check() + " has an error, which is not the pupil's:\n"
                + result.getTraceback());
        }
    }
}
