// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The script sessions of a program. A script's {@code Box("crate", ...)} names no service, so this class finds its
 * session. Objects share only this class and the store of the project folder. Any thread.
 */
final class ScriptSessions {
    static final ScriptSessions ALL = new ScriptSessions();

    private final ScriptRun script = new ScriptRun();
    /** Ordered by last use. */
    private volatile List<ScriptSession> open = List.of();
    private volatile int starts;
    /** Robots of the project that are still referenced, in the order of their creation. */
    private final List<WeakReference<Object>> made = new ArrayList<>();

    private ScriptSessions() {
    }

    /** Returns the current script run. There is one per program, since the program has one project. */
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

    /** Returns the robots created in this program that are still referenced, in the order of their creation. */
    synchronized <T> List<T> made(Class<T> type) {
        return made.stream().map(WeakReference::get).filter(type::isInstance).map(type::cast)
            .collect(Collectors.toList());
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

    /** Marks a session as used last, unless it is closed. */
    synchronized void use(ScriptSession scriptSession) {
        List<ScriptSession> others = new ArrayList<>(open);
        if (others.remove(scriptSession)) {
            others.add(scriptSession);
            open = List.copyOf(others);
        }
    }

    /** Returns the session whose simulation runs, otherwise the one used last; null if none is open. */
    ScriptSession present() {
        List<ScriptSession> now = open;
        return now.stream().filter(ScriptSession::isSimulating).findFirst()
            .orElse(now.isEmpty() ? null : now.get(now.size() - 1));
    }

    /** Returns the number of the simulation that starts, from 1. */
    synchronized int nextStart() {
        return ++starts;
    }

    /** Returns the number of simulations started; an object stores it on creation. */
    int starts() {
        return starts;
    }

    /**
     * Returns the running simulation's actions for an object.
     *
     * @param madeAfter number of starts before the object was created
     * @return null if no simulation runs that has read the object
     */
    ScriptSession.Acts actsFor(int madeAfter) {
        ScriptSession present = present();
        return present == null ? null : present.actsFor(madeAfter);
    }
}
