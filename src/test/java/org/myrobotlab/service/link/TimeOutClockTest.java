// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

import static org.junit.Assert.assertEquals;

import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.serial.PortClock;

/** Timeouts use simulated time, but outside of lock-step never faster than real time. */
@Category(Slow.class)
public class TimeOutClockTest {
    private static final double EXACT = 1e-9;

    private double simulated;
    private long nanos;
    private boolean lockStep;
    private boolean underWay;

    private final PortClock port = new PortClock() {
        @Override
        public double now() {
            return simulated;
        }

        @Override
        public void await(double time) {
            throw new UnsupportedOperationException();
        }

        @Override
        public boolean isLockStep() {
            return lockStep;
        }

        @Override
        public void addTicker(Runnable ticker) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void removeTicker(Runnable ticker) {
            throw new UnsupportedOperationException();
        }
    };
    private final TimeOutClock clock = new TimeOutClock(() -> port, () -> nanos, () -> underWay);

    private void pass(double simulatedSeconds, double realSeconds) {
        simulated += simulatedSeconds;
        nanos += Math.round(realSeconds * 1e9);
    }

    @Test
    public void aSimulationThatIsFasterThanRealTimeDoesNotShortenThem() {
        clock.restart();
        for (int i = 0; i < 100; i++) {
            pass(100, 0.02);
            clock.now();
        }
        assertEquals(2, clock.now(), EXACT);
    }

    @Test
    public void aSlowOneLengthensThem() {
        clock.restart();
        for (int i = 0; i < 100; i++) {
            pass(0.01, 0.02);
            clock.now();
        }
        assertEquals(1, clock.now(), EXACT);
    }

    @Test
    public void unevenStepsAtRealTimeLoseNothing() {
        clock.restart();
        pass(0, 0.05);
        for (int i = 0; i < 100; i++) {
            pass(i % 3 == 0 ? 0 : 0.03, 0.02);
            clock.now();
        }
        assertEquals(simulated, clock.now(), EXACT);
    }

    @Test
    public void aPauseAccumulatesALimitedTime() {
        clock.restart();
        pass(0, 3600);
        clock.now();
        pass(3600, 0);
        assertEquals(0.25, clock.now(), EXACT);
    }

    @Test
    public void itPausesWhileBytesAreInTransit() {
        clock.restart();
        pass(1, 1);
        double before = clock.now();
        underWay = true;
        for (int i = 0; i < 100; i++) {
            pass(0.1, 0.1);
            assertEquals(before, clock.now(), EXACT);
        }
        underWay = false;
        pass(0.1, 0.1);
        assertEquals(before + 0.1, clock.now(), EXACT);
    }

    @Test
    public void inLockStepItIsThePortsClock() {
        lockStep = true;
        clock.restart();
        pass(1234.5, 0);
        assertEquals(1234.5, clock.now(), 0);
    }

    @Test
    public void aResetDoesNotDecreaseIt() {
        clock.restart();
        pass(10, 20);
        clock.now();
        pass(-simulated, 0);
        double after = clock.now();
        assertEquals(0.25, after, EXACT);
        pass(0.1, 0.1);
        assertEquals(after + 0.1, clock.now(), EXACT);
    }
}
