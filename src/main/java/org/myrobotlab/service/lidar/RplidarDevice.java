// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.List;
import java.util.function.Consumer;
import org.SEAR.protocol.lidar.LidarModel;
import org.SEAR.protocol.rplidar.Health;
import org.SEAR.protocol.rplidar.Info;
import org.SEAR.protocol.rplidar.RplidarCommand;
import org.myrobotlab.service.lidar.requests.DeviceLine;

/**
 * An RPLIDAR A1, which turns continuously (its USB adapter runs the motor while DTR is off). It sends full turns of
 * standard or express scans; the device reports the requested spread of them. Any thread; never blocks.
 */
final class RplidarDevice extends AbstractLidarDevice<RplidarDriver> {
    private static final int CIRCLE = 360;
    private static final double STANDARD = 1;
    private static final double EXPRESS = 0.5;
    /** Finest resolution of standard scans, degrees; finer needs express scans with about twice as many values. */
    private static final double FINEST_STANDARD = 0.75;
    private static final double COARSEST = 2;
    private static final double TIMEOUT = 1;
    /** Seconds. The motor may turn as slowly as once per second, and the first, incomplete turn is dropped. */
    private static final double TURN_TIMEOUT = 4;
    /** Pause after STOP, seconds; common drivers wait 1 to 100 ms. */
    private static final double AFTER_STOP = 0.02;

    private final LidarModel model;
    private volatile int spread = CIRCLE;
    private volatile double resolution = STANDARD;
    /** The requested state, which the scanner may not have confirmed yet. */
    private volatile boolean toStream;

    RplidarDevice(LidarModel model, LidarListener listener) {
        super(listener);
        this.model = model;
    }

    @Override
    RplidarDriver driverAt(DeviceLine line) {
        return new RplidarDriver(line, listener, LidarModels.bauds(model), this::turned);
    }

    @Override
    public void clear() {
        super.clear();
        toStream = false;
        spread = CIRCLE;
        resolution = STANDARD;
    }

    @Override
    public void learn() {
        link().setDtr(false);
        stop();
        ask("the request for its type", RplidarCommand.GET_INFO,
            bytes -> listener.info("the LIDAR is an RPLIDAR of " + new Info(bytes)));
        ask("the request for its health", RplidarCommand.GET_HEALTH, bytes -> onHealth(new Health(bytes)));
        listener.unit(true);
        listener.scanMode(spread, resolution);
    }

    private void onHealth(Health health) {
        if (health.getState() != Health.GOOD) {
            listener.error("the LIDAR reports " + (health.getState() == Health.ERROR ? "an error" : "a warning")
                + ", code " + health.getCode());
        }
    }

    @Override
    public void setBaud(int baud) {
        listener.baud(baud);
    }

    @Override
    public void setVariant(int newSpread, double newResolution) {
        if (newSpread < 1 || newSpread > CIRCLE || !(newResolution > 0 && newResolution <= COARSEST)) {
            throw new IllegalArgumentException("scan mode is spread " + newSpread + ", resolution " + newResolution
                + ", legal: spread 1 to 360, resolution 1 (standard) or 0.5 (express)");
        }
        spread = newSpread;
        resolution = newResolution < FINEST_STANDARD ? EXPRESS : STANDARD;
        listener.scanMode(spread, resolution);
        if (toStream) {
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
            driver().ask(new RplidarRequest("a single scan", scanCommand(), true, TURN_TIMEOUT, bytes -> { }));
            stop();
        }
    }

    @Override
    public void setStreaming(boolean on) {
        toStream = on;
        if (on) {
            driver().ask(new RplidarRequest("streaming", scanCommand(), false, TIMEOUT, bytes -> streams(true)));
        } else {
            stop();
            ask("the end of streaming", RplidarCommand.GET_HEALTH, bytes -> streams(false));
        }
    }

    private RplidarCommand scanCommand() {
        return resolution < FINEST_STANDARD ? RplidarCommand.EXPRESS_SCAN : RplidarCommand.SCAN;
    }

    private void stop() {
        driver().ask(new RplidarRequest("the end of a scan", RplidarCommand.STOP, false, AFTER_STOP, bytes -> { }));
    }

    private void ask(String name, RplidarCommand command, Consumer<byte[]> then) {
        driver().ask(new RplidarRequest(name, command, false, TIMEOUT, then));
    }

    private void turned(List<RplidarTurn.Sample> turn) {
        RangeScan scan = RplidarTurn.scan(turn, spread, link().now());
        keep(scan);
        listener.scan(scan);
    }
}
