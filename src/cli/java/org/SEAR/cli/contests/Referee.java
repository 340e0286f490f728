package org.SEAR.cli.contests;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.myrobotlab.embedded.python.PythonEngine;
import org.myrobotlab.embedded.python.ScriptResult;

/** The referee.py of a contest, in an interpreter that no entrant's script sees. The contest's thread. */
final class Referee {
    private static final double MOST_SECONDS = 3600;
    private static final String STEPPED = "stepped";

    private final Path file;
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final PythonEngine engine;
    private final double seconds;

    /** @throws IOException that says what is wrong with it */
    Referee(Path file) throws IOException {
        this.file = file;
        engine = new PythonEngine("referee of " + file, printed, printed);
        checked(engine.runFile(file.toString()));
        Object limit = engine.get("SECONDS");
        if (!engine.has(STEPPED) || !(limit instanceof Number)) {
            throw new IOException(file + " lacks " + (engine.has(STEPPED) ? "SECONDS, how much simulated time there is"
                : "the function stepped(contest)"));
        }
        seconds = ((Number) limit).doubleValue();
        if (!(seconds > 0 && seconds <= MOST_SECONDS)) {
            throw new IOException(file + ": SECONDS is " + seconds + ", legal: above 0 to " + MOST_SECONDS);
        }
    }

    private void checked(ScriptResult result) throws IOException {
        if (result.getExitCode() != 0 && result.getTraceback() == null) {
            throw new IOException(file + " has ended itself, with status " + result.getExitCode() + ", legal: contest.end(words)");
        }
        if (result.getTraceback() != null) {
            throw new IOException(file + " has an error, which is no entrant's:\n" + result.getTraceback());
        }
    }

    /** Simulated seconds that the contest has at most. */
    double getSeconds() {
        return seconds;
    }

    /**
     * Calls a function of it, if it has it.
     *
     * @throws IOException with the error that it raises
     */
    void call(String function, Contest contest) throws IOException {
        if (engine.has(function)) {
            checked(engine.call(function, contest));
        }
    }

    /** What it has printed, once. */
    String takePrinted() {
        String text = new String(printed.toByteArray(), StandardCharsets.UTF_8);
        printed.reset();
        return text;
    }

    void close() {
        engine.close();
    }
}
