// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.SEAR.devices.LineListener;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.orders.BodyOrder;

/**
 * Observes all inputs and outputs of a run, in order, without changing anything. Each method does nothing unless
 * overridden. Simulation thread.
 */
public interface RunListener extends LineListener {
    /** A drive command runs in this step. */
    default void drive(DriveCommand command) {
    }

    /** Between two steps: a motor, servo, light or steering received a command. */
    default void order(ActuatorOrder order) {
    }

    /** Between two steps: an object or robot received a velocity or a force, or gravity changed. */
    default void order(BodyOrder order) {
    }

    /** Between two steps: a device was switched on or off. */
    default void power(String device, boolean on) {
    }

    /**
     * Between two steps: an object or robot was teleported; it is at rest.
     *
     * @param start its pose after a reset
     */
    default void moved(String name, Pose start, Pose to) {
    }

    /** Between two steps: the world goes back to its start. */
    default void reset() {
    }

    /**
     * Between two steps: lines were serviced; their bytes were reported before this call.
     *
     * @param part of the step, see {@link Simulation#serviceDevices}; 0 while time stands still, see
     *     {@link Simulation#answer}
     */
    default void devicesServiced(int part) {
    }

    /** A step has ended: its snapshot and outputs are available. */
    default void stepped(Simulation simulation) {
    }

    /** Time stands still; called once a second at least. */
    default void idle() {
    }

    /**
     * Forwards each event to several listeners in turn. Immutable: adding or removing a listener makes a new instance.
     * Simulation thread.
     */
    final class Several implements RunListener {
        private final List<RunListener> all;

        private Several(List<RunListener> all) {
            this.all = all;
        }

        /**
         * Returns the listeners after one was added or removed.
         *
         * @param before null for no listener
         * @param on true: add; false: remove
         * @return null for no listener
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
