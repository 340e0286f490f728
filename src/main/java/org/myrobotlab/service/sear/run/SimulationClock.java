// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.serial.PortClock;

/** Simulated time for ports. Any thread. */
final class SimulationClock extends PortClock {
    /** Interval at which waiting threads check the time, milliseconds; a step of real time is 16. */
    private static final long LOOK = 4;

    private final Simulation simulation;
    private final List<Runnable> tickers = new CopyOnWriteArrayList<>();
    private volatile boolean lockStep;

    SimulationClock(Simulation simulation, boolean lockStep) {
        this.simulation = simulation;
        this.lockStep = lockStep;
    }

    @Override
    public double now() {
        return simulation.snapshot().time;
    }

    @Override
    public synchronized void await(double time) throws InterruptedException {
        while (now() < time && !lockStep && current() == this) {
            wait(LOOK);
        }
    }

    @Override
    public boolean isLockStep() {
        return lockStep && current() == this;
    }

    void setLockStep(boolean on) {
        lockStep = on;
        wake();
    }

    /** Makes waiting threads check again after a change. */
    synchronized void wake() {
        notifyAll();
    }

    /** Runs the tickers after a step of lock-step. */
    void tick() {
        tickers.forEach(Runnable::run);
    }

    /** Moves the tickers to the new clock after a reset. */
    void moveTickersTo(SimulationClock other) {
        other.tickers.addAll(tickers);
    }

    @Override
    public void addTicker(Runnable ticker) {
        tickers.add(ticker);
    }

    @Override
    public void removeTicker(Runnable ticker) {
        tickers.remove(ticker);
    }
}
