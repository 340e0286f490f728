package org.SEAR.POJOs;

import java.util.Collection;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Where the objects of a service are made: who is told what their makers should know, and the simulation that has read them. Each SEAR service has
 * its own; an object that a script makes comes to that whose simulation runs, else to that which was used last. The files lie in the project folder,
 * which is the program's. Any thread.
 */
public final class ScriptSession {
    private final Consumer<String> reported;
    private volatile Run run;

    /** What a running simulation does for its objects, between two steps, before it returns. */
    public interface Acts {
        /**
         * Gives a thing a velocity.
         *
         * @param x m/s in the world frame, likewise y and z
         * @throws IllegalArgumentException if the simulation has nothing of that name that can move
         */
        void setVelocity(String name, double x, double y, double z);

        /**
         * Has a thing turn.
         *
         * @param x degrees a second about the world's x, likewise y and z
         * @throws IllegalArgumentException if the simulation has nothing of that name that can move
         */
        void setSpin(String name, double x, double y, double z);
    }

    /** A simulation from its start on. */
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

    /**
     * A workbench where nothing is made yet.
     *
     * @param told is called on the thread that makes an object
     */
    public ScriptSession(Consumer<String> told) {
        this.reported = told;
    }

    /** It is used from now on. */
    public void open() {
        ScriptSessions.ALL.add(this);
    }

    /** Nothing is made here any more. */
    public void close() {
        ScriptSessions.ALL.remove(this);
    }

    /**
     * A simulation has read the objects, and looks at no later ones.
     *
     * @param forObjects null if it does nothing for them
     * @param running whether it still runs
     */
    public void begin(Acts forObjects, BooleanSupplier running) {
        run = new Run(forObjects, running, ScriptSessions.ALL.nextStart());
        ScriptSessions.ALL.use(this);
    }

    /** Its simulation has ended. */
    public void end() {
        run = null;
    }

    /** Another project, maybe an empty one, is in the place of the one whose objects were made until now. */
    public void anotherProject() {
        ScriptSessions.ALL.use(this);
        ScriptSessions.ALL.script().forget();
        ScriptSessions.ALL.forgetMade();
    }

    /** The calling script has opened a project or taken something out of one, and means to have what is in it. */
    public void projectTaken() {
        ScriptSessions.ALL.use(this);
        ScriptSessions.ALL.script().hasTaken();
    }

    /**
     * Which objects the calling script, which has made others, did not make: of an earlier run, as the file of an object that was renamed, or of
     * another script.
     *
     * @param names of the project's objects and robots
     * @return one line; empty if there are none
     */
    public String ofOthers(Collection<String> names) {
        return Notices.ofOthers(ScriptSessions.ALL.script().others(names));
    }

    /**
     * Where the calling script, or the last one, has made the first object that a text names.
     *
     * @return {@code line 7 of first.py}; empty if it names none of them
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

    /** What its simulation does for an object that was made after so many starts; null unless it runs and has read it. */
    Acts actsFor(int madeAfter) {
        Run present = run;
        return present != null && madeAfter < present.number && present.runs.getAsBoolean() ? present.acts : null;
    }
}
