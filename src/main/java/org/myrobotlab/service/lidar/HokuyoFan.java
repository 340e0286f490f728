// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.Locale;
import org.SEAR.protocol.scip.HokuyoModel;
import org.SEAR.protocol.scip.Reply;
import org.SEAR.protocol.scip.ScanCommand;

/** The steps of a Hokuyo scanner and the commands that measure part of them. Immutable. */
final class HokuyoFan {
    private static final double CIRCLE = 360;
    private static final double STRAIGHT_AHEAD = 90;
    private static final double ROUNDING = 1e-6;

    /** Least and greatest distance, millimetres. */
    final int least;
    final int greatest;
    private final double stepAngle;
    private final int first;
    private final int last;
    private final int front;

    private HokuyoFan(int least, int greatest, int steps, int first, int last, int front) {
        if (steps <= 0 || first < 0 || first >= last || front < first || front > last) {
            throw new IllegalArgumentException("ARES " + steps + ", AMIN " + first + ", AFRT " + front
                + ", AMAX " + last);
        }
        this.least = least;
        this.greatest = greatest;
        this.stepAngle = CIRCLE / steps;
        this.first = first;
        this.last = last;
        this.front = front;
    }

    /** Returns the factory values of a model. */
    static HokuyoFan of(HokuyoModel model) {
        return new HokuyoFan(model.getLeast(), model.getGreatest(), model.getSteps(), model.getFirst(), model.getLast(),
            model.getFront());
    }

    /**
     * Returns the values that a scanner reports.
     *
     * @param reply to PP
     * @throws IllegalArgumentException if the values contradict each other
     */
    static HokuyoFan of(Reply reply) {
        return new HokuyoFan(reply.number("DMIN"), reply.number("DMAX"), reply.number("ARES"), reply.number("AMIN"),
            reply.number("AMAX"), reply.number("AFRT"));
    }

    /** Returns the command that measures all steps. */
    ScanCommand whole() {
        return new ScanCommand("MD", first, last, 1, 0, 0, "");
    }

    /**
     * Returns the command whose steps are nearest to the given spread and resolution, centred on the front.
     *
     * @throws IllegalArgumentException with the legal values
     */
    ScanCommand part(int spread, double resolution) {
        double widest = Math.ceil((last - first) * stepAngle);
        double coarsest = ScanCommand.MAX_CLUSTER * stepAngle;
        if (!(spread > 0 && spread <= widest && resolution > 0 && resolution <= Math.min(spread, coarsest))) {
            throw new IllegalArgumentException(
                String.format(Locale.ROOT, "scan mode is spread %d, resolution %s, legal: spread 1 to %.0f, "
                + "resolution %s to %.2f, at most the spread", spread, resolution, widest, stepAngle, coarsest));
        }
        int cluster = (int) Math.max(1, Math.round(resolution / stepAngle));
        if (spread == widest && cluster == 1) {
            return whole();
        }
        int values = (int) Math.floor(spread / (cluster * stepAngle) + ROUNDING) + 1;
        values -= values % 2 == 0 ? 1 : 0;
        while (start(values, cluster) < first || start(values, cluster) + values * cluster - 1 > last) {
            values -= 2;
        }
        int start = start(values, cluster);
        return new ScanCommand("MD", start, start + values * cluster - 1, cluster, 0, 0, "");
    }

    private int start(int values, int cluster) {
        return front - (values * cluster - 1) / 2;
    }

    /** Returns the degrees between two values. */
    double resolution(ScanCommand command) {
        return command.getCluster() * stepAngle;
    }

    /** Returns the degrees from first to last value. */
    double spread(ScanCommand command) {
        return (command.getValues() - 1) * resolution(command);
    }

    /**
     * Returns the scan in a reply.
     *
     * @throws IllegalArgumentException if the number of values differs from the command's
     */
    RangeScan scan(Reply reply, double time) {
        ScanCommand command = ScanCommand.of(reply.getEcho());
        int[] values = reply.values(command.getCharacters());
        if (values.length != command.getValues()) {
            throw new IllegalArgumentException(values.length + " values");
        }
        double middle = command.getStart() + (command.getCluster() - 1) / 2.0;
        double[] angles = RangeScan.angles(values.length, STRAIGHT_AHEAD + (middle - front) * stepAngle,
            resolution(command));
        return new RangeScan(values, "mm", least, greatest + 1, angles, resolution(command), time);
    }
}
