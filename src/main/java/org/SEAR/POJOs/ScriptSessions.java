package org.SEAR.POJOs;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The workbenches of a program. A script's {@code Box("crate", ...)} names no service: here it finds whose it is. Beside the store of the project
 * folder this is all that objects share. Any thread.
 */
final class ScriptSessions {
    static final ScriptSessions ALL = new ScriptSessions();

    private final ScriptRun script = new ScriptRun();
    /** In the order in which they were used last. */
    private volatile List<ScriptSession> open = List.of();
    private volatile int starts;
    /** Robots of the project that somebody still has, in the order in which they were made. */
    private final List<WeakReference<Object>> made = new ArrayList<>();

    private ScriptSessions() {
    }

    /** What the present run of a script has made: of the program's one project, whichever service it asks. */
    ScriptRun script() {
        return script;
    }

    synchronized void made(Object robot) {
        made.removeIf(one -> one.get() == null);
        made.add(new WeakReference<>(robot));
    }

    synchronized void forgetMade() {
        made.clear();
    }

    /** What of the project was made in this program, and is still had by somebody, in the order in which it was made. */
    synchronized <T> List<T> made(Class<T> type) {
        return made.stream().map(WeakReference::get).filter(type::isInstance).map(type::cast).collect(Collectors.toList());
    }

    synchronized void add(ScriptSession scriptSession) {
        List<ScriptSession> more = new ArrayList<>(open);
        more.add(scriptSession);
        open = List.copyOf(more);
    }

    synchronized void remove(ScriptSession scriptSession) {
        List<ScriptSession> fewer = new ArrayList<>(open);
        fewer.remove(scriptSession);
        open = List.copyOf(fewer);
    }

    /** From now on it is the one that was used last, unless it is closed. */
    synchronized void use(ScriptSession scriptSession) {
        List<ScriptSession> others = new ArrayList<>(open);
        if (others.remove(scriptSession)) {
            others.add(scriptSession);
            open = List.copyOf(others);
        }
    }

    /** The one whose simulation runs, else the one that was used last; null if none is open. */
    ScriptSession present() {
        List<ScriptSession> now = open;
        return now.stream().filter(ScriptSession::isSimulating).findFirst().orElse(now.isEmpty() ? null : now.get(now.size() - 1));
    }

    /** Number of a simulation that begins, from 1. */
    synchronized int nextStart() {
        return ++starts;
    }

    /** How many simulations have begun: an object remembers it when it is made. */
    int starts() {
        return starts;
    }

    /**
     * What the simulation that runs does for an object.
     *
     * @param madeAfter so many starts
     * @return null if no simulation runs that has read it
     */
    ScriptSession.Acts actsFor(int madeAfter) {
        ScriptSession present = present();
        return present == null ? null : present.actsFor(madeAfter);
    }
}
