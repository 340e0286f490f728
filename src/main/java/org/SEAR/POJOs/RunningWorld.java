package org.SEAR.POJOs;

import java.util.function.BooleanSupplier;

/**
 * The simulation that runs, so far as objects that were made before its start act on what they have become in it. At most one runs in a program. Any
 * thread.
 */
public final class RunningWorld {
    private static volatile Acts acts;
    private static volatile int starts;
    private static volatile BooleanSupplier simulating = () -> false;

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

    private RunningWorld() {
    }

    /**
     * A simulation has read its objects.
     *
     * @param forObjects null if it does nothing for them
     * @param running whether it still runs
     */
    public static synchronized void begin(Acts forObjects, BooleanSupplier running) {
        starts++;
        acts = forObjects;
        simulating = running;
    }

    /** No simulation runs. */
    public static synchronized void end() {
        acts = null;
        simulating = () -> false;
    }

    /** How many simulations have begun: an object remembers it when it is made. */
    static int starts() {
        return starts;
    }

    /**
     * What to tell about an object.
     *
     * @param madeAfter so many starts
     * @return null if no simulation runs that has read it
     */
    static Acts reading(int madeAfter) {
        return madeAfter < starts && simulating.getAsBoolean() ? acts : null;
    }
}
