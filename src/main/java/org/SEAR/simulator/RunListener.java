package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.SEAR.devices.LineListener;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.orders.BodyOrder;

/**
 * Looks at everything that goes into a run and comes out of it, in its order, without changing anything; each method does nothing unless it is
 * overridden. Simulation thread.
 */
public interface RunListener extends LineListener {
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
     * @param part of the step, as {@link Simulation#serviceDevices} has it; 0 if time stands still, as {@link Simulation#answer} has it
     */
    default void devicesServiced(int part) {
    }

    /** A step has ended: its snapshot and outputs are there. */
    default void stepped(Simulation simulation) {
    }

    /** Time stands still: called now and then, once a second at least. */
    default void idle() {
    }

    /** Several who look at one run, told one after the other. Who comes or leaves makes another of these. Simulation thread. */
    final class Several implements RunListener {
        private final List<RunListener> all;

        private Several(List<RunListener> all) {
            this.all = all;
        }

        /**
         * Who looks when one has come or left.
         *
         * @param before null for nobody
         * @param on whether it comes
         * @return null for nobody
         */
        public static RunListener changed(RunListener before, RunListener who, boolean on) {
            List<RunListener> now = new ArrayList<>(before instanceof Several ? ((Several) before).all : before == null
                ? List.of() : List.of(before));
            now.remove(who);
            if (on) {
                now.add(who);
            }
            return now.isEmpty() ? null : now.size() == 1 ? now.get(0) : new Several(now);
        }

        private void report(Consumer<RunListener> event) {
            all.forEach(event);
        }

        @Override
        public void drive(DriveCommand command) {
            report(one -> one.drive(command));
        }

        @Override
        public void order(ActuatorOrder order) {
            report(one -> one.order(order));
        }

        @Override
        public void order(BodyOrder order) {
            report(one -> one.order(order));
        }

        @Override
        public void power(String device, boolean on) {
            report(one -> one.power(device, on));
        }

        @Override
        public void moved(String name, Pose start, Pose to) {
            report(one -> one.moved(name, start, to));
        }

        @Override
        public void reset() {
            report(RunListener::reset);
        }

        @Override
        public void devicesServiced(int part) {
            report(one -> one.devicesServiced(part));
        }

        @Override
        public void stepped(Simulation simulation) {
            report(one -> one.stepped(simulation));
        }

        @Override
        public void idle() {
            report(RunListener::idle);
        }

        @Override
        public void heard(SerialLine line, byte[] bytes, int count) {
            report(one -> one.heard(line, bytes, count));
        }

        @Override
        public void said(SerialLine line, byte[] bytes) {
            report(one -> one.said(line, bytes));
        }

        @Override
        public void baud(SerialLine line, int baud) {
            report(one -> one.baud(line, baud));
        }

        @Override
        public void opened(SerialLine line) {
            report(one -> one.opened(line));
        }

        @Override
        public void lineClosed(SerialLine line) {
            report(one -> one.lineClosed(line));
        }
    }
}
