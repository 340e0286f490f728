// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import org.SEAR.protocol.lidar.LidarModel;
import org.SEAR.protocol.scip.HokuyoModel;
import org.SEAR.protocol.scip.Reply;
import org.SEAR.protocol.scip.ScanCommand;
import org.SEAR.protocol.scip.ScipStatus;
import org.myrobotlab.service.lidar.requests.DeviceLine;

/** A Hokuyo scanner that uses SCIP 2.0. The scanner reports its own field of view. Any thread; never blocks. */
final class HokuyoDevice extends AbstractLidarDevice<ScipDriver> {
    /** Leaves SCIP 1.1, the start mode of older scanners, and the time adjustment mode. */
    private static final String TO_NORMAL = "SCIP2.0\nTM2\n";
    private static final int SHORT_REPLY = 32;
    private static final int LONG_REPLY = 400;
    private static final int LONGEST_SCAN = 3400;
    /** Seconds; common drivers also wait 1 s. */
    private static final double TIMEOUT = 1;

    private final LidarModel model;
    private volatile HokuyoFan fan;
    /** The command for the next measurement. */
    private volatile ScanCommand wanted;
    /** The requested spread, degrees; 0 for the whole field of view. */
    private int spread;
    private double resolution;
    private double reportedSpread;
    private double reportedResolution;
    /** The requested state, which the scanner may not have confirmed yet. */
    private volatile boolean toStream;

    HokuyoDevice(LidarModel model, LidarListener listener) {
        super(listener);
        this.model = model;
        wholeFan();
    }

    @Override
    ScipDriver driverAt(DeviceLine line) {
        return new ScipDriver(line, listener, LidarModels.bauds(model), this::scanned);
    }

    @Override
    public void clear() {
        super.clear();
        toStream = false;
        wholeFan();
    }

    private synchronized void wholeFan() {
        fan = HokuyoFan.of(HokuyoModel.of(model));
        wanted = fan.whole();
        spread = 0;
        reportedSpread = 0;
    }

    @Override
    public void learn() {
        driver().ask(new ScipRequest("the request for the parameters", TO_NORMAL, "PP", LONG_REPLY, TIMEOUT, reply -> {
            if (succeeded(reply, "the request for the parameters")) {
                listener.unit(true);
                learnt(HokuyoFan.of(reply));
            }
        }));
        ask("the request for the state", "II", LONG_REPLY, this::onState);
    }

    private void onState(Reply reply) {
        String mode = reply.property("MESM");
        boolean streams = mode != null && mode.startsWith("Measuring");
        if (streams != isStreaming()) {
            toStream |= streams;
            streams(streams);
        }
    }

    private synchronized void learnt(HokuyoFan reported) {
        fan = reported;
        wanted = spread == 0 ? reported.whole() : reported.part(spread, resolution);
        if (!isStreaming()) {
            report(reported.spread(wanted), reported.resolution(wanted));
        }
    }

    private synchronized void report(double newSpread, double newResolution) {
        if (newSpread != reportedSpread || newResolution != reportedResolution) {
            reportedSpread = newSpread;
            reportedResolution = newResolution;
            listener.scanMode(newSpread, newResolution);
        }
    }

    @Override
    public void setBaud(int baud) {
        if (HokuyoModel.of(model).isUsbOnly()) {
            throw new IllegalArgumentException("a " + model.getName() + " is connected by USB, which has no baud rate");
        }
        String name = "the change to " + baud + " baud";
        ask(name, HokuyoModel.baudCommand(baud), SHORT_REPLY, reply -> {
            if (ScipStatus.UNCHANGED.equals(reply.getStatus()) || succeeded(reply, name)) {
                driver().changeBaud(baud);
                listener.baud(baud);
            }
        });
    }

    @Override
    public void setVariant(int newSpread, double newResolution) {
        synchronized (this) {
            wanted = fan.part(newSpread, newResolution);
            spread = newSpread;
            resolution = newResolution;
        }
        boolean wasStreaming = toStream;
        if (wasStreaming) {
            setStreaming(false);
        }
        report(fan.spread(wanted), fan.resolution(wanted));
        if (wasStreaming) {
            setStreaming(true);
        }
    }

    @Override
    public void setUnit(boolean millimetres) {
        setOnlyUnit(millimetres, model);
    }

    @Override
    public void singleScan() {
        if (!toStream) {
            measure("a single scan", 1, reply -> succeeded(reply, "a single scan"));
        }
    }

    @Override
    public void setStreaming(boolean on) {
        toStream = on;
        if (on) {
            measure("streaming", 0, reply -> streams(reply, true, "streaming"));
        } else {
            ask("the end of streaming", "QT", LONGEST_SCAN, reply -> streams(reply, false, "the end of streaming"));
        }
    }

    private void streams(Reply reply, boolean on, String name) {
        if (succeeded(reply, name)) {
            streams(on);
        }
    }

    private void measure(String name, int count, Consumer<Reply> then) {
        ask(name, wanted.withCount(count).toString(), LONGEST_SCAN, then);
    }

    private void ask(String name, String command, int replyLength, Consumer<Reply> then) {
        driver().ask(new ScipRequest(name, "", command, replyLength, TIMEOUT, then));
    }

    private void scanned(Reply reply) {
        RangeScan scan = fan.scan(reply, link().now());
        keep(scan);
        report(scan.spread, scan.resolution);
        listener.scan(scan);
    }

    private boolean succeeded(Reply reply, String what) {
        boolean done = ScipStatus.OK.equals(reply.getStatus());
        if (!done) {
            listener.error("the LIDAR rejected " + what + " (status " + reply.getStatus() + ")");
        }
        return done;
    }
}
