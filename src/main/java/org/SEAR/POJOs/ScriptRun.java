package org.SEAR.POJOs;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/**
 * Which names the present run of a Python script has given to objects. Jython makes a class of its own of each run of a script; a script that is run
 * again is another run, which may make the same objects. Any thread.
 */
final class ScriptRun {
    private static final String SCRIPT = "org.python.pycode.";
    private static final Set<String> NAMES = new HashSet<>();
    private static String run = "";

    private ScriptRun() {
    }

    /** Whether this run of a script has given the name before; never outside of scripts. */
    static synchronized boolean isAgain(String name) {
        Optional<String> present = StackWalker.getInstance().walk(frames -> frames.map(StackWalker.StackFrame::getClassName)
            .filter(type -> type.startsWith(SCRIPT)).reduce((inner, outer) -> outer));
        if (present.isEmpty()) {
            return false;
        }
        if (!present.get().equals(run)) {
            run = present.get();
            NAMES.clear();
        }
        return !NAMES.add(name);
    }
}
