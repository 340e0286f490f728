// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.servo;

import java.util.Arrays;
import org.SEAR.geometry.TimeStep;

/** Dead time of a command: each value takes effect a number of steps later. Simulation thread. */
public final class DeadTime {
    private final double[] line;
    private int at;
    private boolean pending;

    /** @param seconds rounded to steps; 0 for none */
    public DeadTime(double seconds) {
        line = new double[(int) Math.round(seconds / TimeStep.SECONDS)];
    }

    /** Forgets earlier commands. */
    public void restart(double value) {
        Arrays.fill(line, value);
        pending = false;
    }

    /** Advances a step: takes its command and returns the one that takes effect. */
    public double pass(double value) {
        if (line.length == 0) {
            return value;
        }
        double due = line[at];
        line[at] = value;
        at = (at + 1) % line.length;
        pending = false;
        for (int i = 0; i < line.length; i++) {
            pending |= line[i] != due;
        }
        return due;
    }

    /** Whether there is a dead time. */
    public boolean isUsed() {
        return line.length > 0;
    }

    /** Whether another command waits for its time. */
    public boolean isPending() {
        return pending;
    }
}
