package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.SEAR.devices.LineTap;
import org.SEAR.devices.SerialLine;
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

    /** Several who look at one run, told one after the other. Who comes or leaves makes another of these. Simulation thread. */
    final class Several implements RunTap {
        private final List<RunTap> all;

        private Several(List<RunTap> all) {
            this.all = all;
        }

        /**
         * Who looks when one has come or left.
         *
         * @param before null for nobody
         * @param on whether it comes
         * @return null for nobody
         */
        public static RunTap changed(RunTap before, RunTap who, boolean on) {
            List<RunTap> now = new ArrayList<>(before instanceof Several ? ((Several) before).all : before == null ? List.of() : List.of(before));
            now.remove(who);
            if (on) {
                now.add(who);
            }
            return now.isEmpty() ? null : now.size() == 1 ? now.get(0) : new Several(now);
        }

        private void tell(Consumer<RunTap> event) {
            all.forEach(event);
        }

        @Override
        public void drive(DriveCommand command) {
            tell(one -> one.drive(command));
        }

        @Override
        public void order(ActuatorOrder order) {
            tell(one -> one.order(order));
        }

        @Override
        public void order(BodyOrder order) {
            tell(one -> one.order(order));
        }

        @Override
        public void power(String device, boolean on) {
            tell(one -> one.power(device, on));
        }

        @Override
        public void moved(String name, Pose start, Pose to) {
            tell(one -> one.moved(name, start, to));
        }

        @Override
        public void reset() {
            tell(RunTap::reset);
        }

        @Override
        public void attended(int part) {
            tell(one -> one.attended(part));
        }

        @Override
        public void stepped(Simulation simulation) {
            tell(one -> one.stepped(simulation));
        }

        @Override
        public void standing() {
            tell(RunTap::standing);
        }

        @Override
        public void heard(SerialLine line, byte[] bytes, int count) {
            tell(one -> one.heard(line, bytes, count));
        }

        @Override
        public void said(SerialLine line, byte[] bytes) {
            tell(one -> one.said(line, bytes));
        }

        @Override
        public void baud(SerialLine line, int baud) {
            tell(one -> one.baud(line, baud));
        }

        @Override
        public void opened(SerialLine line) {
            tell(one -> one.opened(line));
        }

        @Override
        public void hungUp(SerialLine line) {
            tell(one -> one.hungUp(line));
        }
    }
}
