// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.scip;

import java.util.function.IntToDoubleFunction;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.EventQueue;
import org.SEAR.protocol.scip.HokuyoModel;
import org.SEAR.protocol.scip.ReplyWriter;
import org.SEAR.protocol.scip.ScanCommand;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.LidarSource;

/**
 * The rotating mirror: when each step is measured, and with which value. Turn k begins, with step 0 at the rear, at k
 * times the scan time, and each step is of its own time.
 */
final class Scanner {
    private static final double MILLIMETRES = 1000;
    private static final double PERCENT = 100;
    private static final double MILLIS = 1000;
    /** Tolerance for rounding errors before a ceiling. */
    private static final double SLACK = 1e-9;

    private final HokuyoModel model;
    private final DeviceContext context;
    private final LidarSource source;
    /** Steps from the front to the further end of the measured angle. */
    private final int half;
    private int slower;
    private double clockZero;

    Scanner(HokuyoModel model, LidarSource source, DeviceContext context) {
        this.model = model;
        this.context = context;
        this.source = source;
        this.half = Math.max(model.getFront() - model.getFirst(), model.getLast() - model.getFront());
    }

    /** @param percent reduction of the motor's speed, 0 to 10 */
    void setSlower(int percent) {
        slower = percent;
    }

    int getSlower() {
        return slower;
    }

    /** Speed of the motor, turns per minute. */
    int getTurns() {
        return (int) Math.round(model.getTurns() * (PERCENT - slower) / PERCENT);
    }

    /** Duration of a turn, seconds. */
    double scanTime() {
        return model.getScanTime() * PERCENT / (PERCENT - slower);
    }

    /** Sensor clock at a time, milliseconds. */
    long clock(double time) {
        return Math.max(0, (long) Math.floor((time - clockZero) * MILLIS + SLACK));
    }

    /** Sets the sensor clock to zero at a time. */
    void setClockZero(double time) {
        clockZero = time;
    }

    /**
     * Measures in the first turn that looks ahead at {@code time} or later; the listener gets the scan after the turn's
     * last step.
     */
    void measure(ScanCommand command, double time, EventQueue events, Listener listener) {
        double scanTime = scanTime();
        double ahead = (double) model.getFront() / model.getSteps();
        double turn = Math.ceil(time / scanTime - ahead - SLACK);
        source.expect((turn + ahead) * scanTime, 2 * half * model.getStepAngle(), model.getStepAngle());
        events.at((turn + ahead) * scanTime, t -> {
            long stamp = clock(turn * scanTime);
            LidarScan still = source.scan(context.truth(), 2 * half * model.getStepAngle(), model.getStepAngle());
            IntToDoubleFunction ranges = step -> source.range(context.truth(), still, step - model.getFront() + half,
                (turn + (double) step / model.getSteps()) * scanTime);
            events.at((turn + (model.getLast() + 1.0) / model.getSteps()) * scanTime,
                end -> listener.measured(new Scan(stamp, values(command, ranges), command.getCharacters()), end));
        });
    }

    /** @param ranges metres by step */
    private int[] values(ScanCommand command, IntToDoubleFunction ranges) {
        int[] values = new int[command.getValues()];
        for (int i = 0; i < values.length; i++) {
            values[i] = nearest(ranges, command.getStart() + i * command.getCluster(), command.getCluster());
        }
        return values;
    }

    /** Shortest distance of some steps; the code of the first step if none has a distance. */
    private int nearest(IntToDoubleFunction ranges, int from, int count) {
        int code = value(ranges, from);
        int least = Integer.MAX_VALUE;
        for (int step = from; step < from + count && step <= model.getLastAsked(); step++) {
            int value = value(ranges, step);
            least = value < model.getLeast() ? least : Math.min(least, value);
        }
        return least == Integer.MAX_VALUE ? code : least;
    }

    private int value(IntToDoubleFunction ranges, int step) {
        if (step < model.getFirst() || step > model.getLast()) {
            return model.getNotMeasured();
        }
        double millimetres = ranges.applyAsDouble(step) * MILLIMETRES;
        if (!(millimetres < model.getGreatest() + 0.5)) {
            return model.getNothing();
        }
        long rounded = Math.round(millimetres);
        return rounded < model.getLeast() ? model.getTooNear() : (int) rounded;
    }

    /** Receives a scan after its last step. */
    interface Listener {
        void measured(Scan scan, double time);
    }

    /** Values of one turn. */
    static final class Scan {
        private final long stamp;
        private final int[] values;
        private final int characters;

        private Scan(long stamp, int[] values, int characters) {
            this.stamp = stamp;
            this.values = values;
            this.characters = characters;
        }

        /** Appends time stamp and values. */
        ReplyWriter write(ReplyWriter reply) {
            return reply.time(stamp).values(values, characters);
        }
    }
}
