package org.SEAR.simulator;

import org.SEAR.devices.LineTap;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.orders.BodyOrder;

/**
 * Looks at everything that goes into a run and comes out of it, in its order, without changing anything; each method does nothing unless it is
 * overridden. Simulation thread.
 */
public interface RunTap extends LineTap {
    /** A command is obeyed in this step. */
    default void drive(DriveCommand command) {
    }

    /** Between two steps a motor, servo, light or steering was told to do something. */
    default void order(ActuatorOrder order) {
    }

    /** Between two steps a thing or a robot got a velocity, or somebody began to push it. */
    default void order(BodyOrder order) {
    }

    /** Between two steps a device was switched on or off. */
    default void power(String device, boolean on) {
    }

    /**
     * Between two steps something was put elsewhere, at rest.
     *
     * @param start where a reset finds it
     */
    default void moved(String name, Pose start, Pose to) {
    }

    /** Between two steps everything went back to the start. */
    default void reset() {
    }

    /**
     * Between two steps bytes went over the lines, as far as was told before.
     *
     * @param part of the step, as {@link Simulation#attend} has it; 0 if time stands still, as {@link Simulation#answer} has it
     */
    default void attended(int part) {
    }

    /** A step has ended: its snapshot and outputs are there. */
    default void stepped(Simulation simulation) {
    }

    /** Time stands still: called now and then, once a second at least. */
    default void standing() {
    }
}
