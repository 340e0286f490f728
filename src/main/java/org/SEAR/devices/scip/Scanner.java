package org.SEAR.devices.scip;

import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.EventQueue;
import org.SEAR.protocol.scip.HokuyoModel;
import org.SEAR.protocol.scip.ReplyWriter;
import org.SEAR.protocol.scip.ScanCommand;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.LidarSource;

/**
 * The turning mirror: when which step is measured, and what is told of it. Turn k begins, with step 0 at the rear, at k times the time of a scan;
 * all distances of a turn are of the instant at which it looks ahead.
 */
final class Scanner {
    private static final double MILLIMETRES = 1000;
    private static final double PERCENT = 100;
    private static final double MILLIS = 1000;
    /** Guards a ceiling against the last bit of a quotient. */
    private static final double SLACK = 1e-9;

    private final HokuyoModel model;
    private final DeviceContext context;
    private final LidarSource source;
    /** Steps to the farther side. */
    private final int half;
    private int slower;
    private double clockZero;

    Scanner(HokuyoModel model, LidarSource source, DeviceContext context) {
        this.model = model;
        this.context = context;
        this.source = source;
        this.half = Math.max(model.getFront() - model.getFirst(), model.getLast() - model.getFront());
    }

    /** @param percent by which it turns slower than it can, 0 to 10 */
    void setSlower(int percent) {
        slower = percent;
    }

    int getSlower() {
        return slower;
    }

    /** Turns a minute. */
    int getTurns() {
        return (int) Math.round(model.getTurns() * (PERCENT - slower) / PERCENT);
    }

    /** Seconds of a turn. */
    double scanTime() {
        return model.getScanTime() * PERCENT / (PERCENT - slower);
    }

    /** Milliseconds of the sensor's clock at a time. */
    long clock(double time) {
        return Math.max(0, (long) Math.floor((time - clockZero) * MILLIS + SLACK));
    }

    /** The sensor's clock begins anew. */
    void setClockZero(double time) {
        clockZero = time;
    }

    /** Measures in the first turn that looks ahead at {@code time} or later, and tells it when that turn's last step has passed. */
    void measure(ScanCommand command, double time, EventQueue events, Listener listener) {
        double scanTime = scanTime();
        double ahead = (double) model.getFront() / model.getSteps();
        double turn = Math.ceil(time / scanTime - ahead - SLACK);
        source.expect((turn + ahead) * scanTime, 2 * half * model.getStepAngle(), model.getStepAngle());
        events.at((turn + ahead) * scanTime, t -> {
            Scan scan = new Scan(clock(turn * scanTime), measure(command), command.getCharacters());
            events.at((turn + (model.getLast() + 1.0) / model.getSteps()) * scanTime, end -> listener.measured(scan, end));
        });
    }

    private int[] measure(ScanCommand command) {
        LidarScan scan = source.scan(context.truth(), 2 * half * model.getStepAngle(), model.getStepAngle());
        int[] values = new int[command.getValues()];
        for (int i = 0; i < values.length; i++) {
            values[i] = nearest(scan, command.getStart() + i * command.getCluster(), command.getCluster());
        }
        return values;
    }

    /** The least distance of some steps; the first one's code if there is none. */
    private int nearest(LidarScan scan, int from, int count) {
        int code = value(scan, from);
        int least = Integer.MAX_VALUE;
        for (int step = from; step < from + count && step <= model.getLastAsked(); step++) {
            int value = value(scan, step);
            least = value < model.getLeast() ? least : Math.min(least, value);
        }
        return least == Integer.MAX_VALUE ? code : least;
    }

    private int value(LidarScan scan, int step) {
        if (step < model.getFirst() || step > model.getLast()) {
            return model.getNotMeasured();
        }
        double millimetres = scan.range(step - model.getFront() + half) * MILLIMETRES;
        if (!(millimetres < model.getGreatest() + 0.5)) {
            return model.getNothing();
        }
        long rounded = Math.round(millimetres);
        return rounded < model.getLeast() ? model.getTooNear() : (int) rounded;
    }

    /** Takes a scan when its last step has passed. */
    interface Listener {
        void measured(Scan scan, double time);
    }

    /** What was measured in one turn. */
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
