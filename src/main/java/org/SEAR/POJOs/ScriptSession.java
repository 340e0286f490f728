// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Collection;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Session of a service in which scripts create objects. It receives the notices about them and knows the simulation
 * that has read them. Each SEAR service has one. A script's object belongs to the session whose simulation runs,
 * otherwise to the session used last. The files lie in the program's project folder. Any thread.
 */
public final class ScriptSession {
    private final Consumer<String> reported;
    private volatile Run run;

    /** Changes that a running simulation makes to its objects between two steps; each call waits for the change. */
    public interface Acts {
        /**
         * Sets the velocity of an object.
         *
         * @param x m/s in the world frame, likewise y and z
         * @throws IllegalArgumentException if the simulation has no movable object of that name
         */
        void setVelocity(String name, double x, double y, double z);

        /**
         * Sets the angular velocity of an object.
         *
         * @param x degrees a second about the world's x, likewise y and z
         * @throws IllegalArgumentException if the simulation has no movable object of that name
         */
        void setSpin(String name, double x, double y, double z);

        /** @param acceleration of gravity, m/s^2 downwards */
        void setGravity(double acceleration);
    }

    /** A started simulation. */
    private static final class Run {
        private final Acts acts;
        private final BooleanSupplier runs;
        private final int number;

        Run(Acts acts, BooleanSupplier runs, int number) {
            this.acts = acts;
            this.runs = runs;
            this.number = number;
        }
    }

    /** @param told receives the notices, on the thread that creates an object */
    public ScriptSession(Consumer<String> told) {
        this.reported = told;
    }

    /** Opens the session, which makes it the one used last. */
    public void open() {
        ScriptSessions.ALL.add(this);
    }

    /** Closes the session to new objects. */
    public void close() {
        ScriptSessions.ALL.remove(this);
    }

    /**
     * Starts a simulation, which has read the objects and ignores later ones.
     *
     * @param forObjects null if the simulation changes no objects
     * @param running whether it still runs
     */
    public void begin(Acts forObjects, BooleanSupplier running) {
        run = new Run(forObjects, running, ScriptSessions.ALL.nextStart());
        ScriptSessions.ALL.use(this);
    }

    /** Ends the simulation. */
    public void end() {
        run = null;
    }

    /** Notes that another project, possibly an empty one, is open. */
    public void anotherProject() {
        ScriptSessions.ALL.use(this);
        ScriptSessions.ALL.script().forget();
        ScriptSessions.ALL.forgetMade();
    }

    /** Notes that the calling script has opened a project or taken objects from one, and uses them. */
    public void projectTaken() {
        ScriptSessions.ALL.use(this);
        ScriptSessions.ALL.script().hasTaken();
    }

    /**
     * Returns the notice about objects that the calling script did not create, if it has created any: objects of an
     * earlier run, the old file of a renamed object, or objects of another script.
     *
     * @param names of the project's objects and robots
     * @return one line; empty if there are none
     */
    public String ofOthers(Collection<String> names) {
        return Notices.ofOthers(ScriptSessions.ALL.script().others(names));
    }

    /**
     * Returns the line of the present or last script that created the first object named in a text.
     *
     * @return {@code line 7 of first.py}; empty if the text names none of its objects
     */
    public static String lineOf(String text) {
        return ScriptSessions.ALL.script().lineOf(text);
    }

    void report(String text) {
        reported.accept(text);
    }

    boolean isSimulating() {
        Run present = run;
        return present != null && present.runs.getAsBoolean();
    }

    /**
     * Returns the simulation's actions for an object; null unless the simulation runs and was started after the object
     * was created.
     */
    Acts actsFor(int madeAfter) {
        Run present = run;
        return present != null && madeAfter < present.number && present.runs.getAsBoolean() ? present.acts : null;
    }
}
