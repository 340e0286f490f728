// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.Configuration;
import org.SEAR.protocol.lms.LmsCommand;
import org.SEAR.protocol.lms.LmsPayload;
import org.SEAR.protocol.lms.LmsStatus;
import org.SEAR.protocol.lms.MeasuringMode;
import org.SEAR.protocol.lms.OperatingMode;
import org.SEAR.protocol.lms.Telegram;
import org.SEAR.protocol.lms.Variant;
import org.myrobotlab.service.lidar.requests.DeviceLine;

/** A SICK LMS2xx scanner: scan modes, units, scans. Any thread; never blocks. */
public final class LmsDevice extends AbstractLidarDevice<LmsDriver> {
    private static final double HUNDREDTHS = 100;
    private static final int OVERHEAD = 10;
    private static final int LONGEST_SCAN = 813;
    /** Argument of command 30h: every value. */
    private static final int ALL_VALUES = 1;
    private static final int CONFIGURATION_AT = 1;
    private static final int SET_CONFIGURATION_AT = 2;
    /** Seconds. A change of operating mode takes up to 3 s (telegram listing, chapter 4). */
    private static final double MODE_TIMEOUT = 3;
    /** Seconds. Writing the configuration takes up to 7 s. */
    private static final double WRITE_TIMEOUT = 15;
    private static final double SHORT_TIMEOUT = 1;

    private volatile MeasuringMode measuringMode = MeasuringMode.FIELDS_A_B_DAZZLE;
    private volatile double resolution = 1;
    private volatile Configuration configuration;
    private String lastComplaint = "";

    public LmsDevice(LidarListener listener) {
        super(listener);
    }

    @Override
    LmsDriver driverAt(DeviceLine line) {
        return new LmsDriver(line, listener, this::scanned);
    }

    @Override
    public void clear() {
        super.clear();
        configuration = null;
    }

    @Override
    public void learn() {
        learnConfiguration();
        ask("the request for the status", LmsCommand.STATUS, LmsCommand.STATUS.request(), LmsStatus.SIZE + OVERHEAD,
            SHORT_TIMEOUT, reply -> onStatus(LmsStatus.of(reply)));
    }

    private void onStatus(LmsStatus status) {
        fan(status.getSpread(), status.getResolution());
        boolean streams = OperatingMode.isStream(status.getMode());
        if (streams != isStreaming()) {
            streams(streams);
        }
    }

    private void fan(int spread, int hundredths) {
        resolution = hundredths / HUNDREDTHS;
        listener.scanMode(spread, resolution);
    }

    private void learnConfiguration() {
        ask("the request for the configuration", LmsCommand.GET_CONFIGURATION, LmsCommand.GET_CONFIGURATION.request(),
            Configuration.SIZE + OVERHEAD,
            SHORT_TIMEOUT, reply -> configured(Configuration.of(reply, CONFIGURATION_AT)));
    }

    private void configured(Configuration reported) {
        configuration = reported;
        measuringMode = reported.getMode() == null ? MeasuringMode.FIELDS_A_B_DAZZLE : reported.getMode();
        listener.unit(reported.isMillimetres());
    }

    @Override
    public void setBaud(int baud) {
        LmsPayload request = LmsCommand.MODE.request().add(Baud.ofRate(baud).getMode());
        ask("the change to " + baud + " baud", LmsCommand.MODE, request, OVERHEAD, MODE_TIMEOUT, reply -> {
            if (succeeded(reply, "the change to " + baud + " baud")) {
                driver().changeBaud(baud);
                listener.baud(baud);
            }
        });
    }

    @Override
    public void setVariant(int spread, double newResolution) {
        Variant variant = Variant.ofDegrees(spread, newResolution);
        if (variant == null) {
            throw new IllegalArgumentException("scan mode is spread " + spread + ", resolution " + newResolution
                + ", legal: 100 with 1, 0.5 or 0.25; 180 with 1 or 0.5");
        }
        LmsPayload request = LmsCommand.VARIANT.request().word(variant.getSpread()).word(variant.getResolution());
        pauseStreaming(() -> ask("scan mode " + spread + " degrees by " + newResolution, LmsCommand.VARIANT, request,
            OVERHEAD + 3, MODE_TIMEOUT, reply -> {
                int nowSpread = reply.wordAt(2);
                int nowResolution = reply.wordAt(4);
                fan(nowSpread, nowResolution);
                if (reply.at(1) != 1) {
                    listener.error("the LIDAR rejected scan mode " + spread + ", " + newResolution + " and stays at "
                        + nowSpread + ", " + nowResolution / HUNDREDTHS);
                }
            }));
    }

    /**
     * Sets the unit: enters installation mode, reads the configuration, writes it with the new unit, returns to
     * measuring.
     */
    @Override
    public void setUnit(boolean millimetres) {
        pauseStreaming(() -> {
            mode("installation mode", LmsCommand.MODE.request().add(OperatingMode.INSTALLATION)
                .text(OperatingMode.PASSWORD));
            learnConfiguration();
            driver().ask(new LmsRequest("the change of unit", LmsCommand.SET_CONFIGURATION, () -> withUnit(millimetres),
                Configuration.SIZE + OVERHEAD, WRITE_TIMEOUT, reply -> {
                    if (reply.at(1) == 1) {
                        configured(Configuration.of(reply, SET_CONFIGURATION_AT));
                    } else {
                        listener.error("the LIDAR rejected the change of unit");
                    }
                }));
            mode("measuring on request", LmsCommand.MODE.request().add(OperatingMode.ON_REQUEST));
        });
    }

    private LmsPayload withUnit(boolean millimetres) {
        if (configuration == null) {
            throw new IllegalStateException("the LIDAR has not reported its configuration");
        }
        return LmsCommand.SET_CONFIGURATION.request().bytes(configuration.withMillimetres(millimetres).toBytes());
    }

    @Override
    public void singleScan() {
        if (!isStreaming()) {
            ask("a single scan", LmsCommand.SCAN, LmsCommand.SCAN.request().add(ALL_VALUES), LONGEST_SCAN,
                SHORT_TIMEOUT, this::scanned);
        }
    }

    private void scanned(Telegram telegram) {
        RangeScan scan = LmsReplies.scan(telegram, measuringMode, resolution, link().now());
        keep(scan);
        listener.scan(scan);
        String complaint = LmsReplies.complaint(telegram);
        if (!complaint.equals(lastComplaint)) {
            lastComplaint = complaint;
            listener.error(complaint.isEmpty() ? "the LIDAR has recovered" : complaint);
        }
    }

    @Override
    public void setStreaming(boolean on) {
        String name = on ? "streaming" : "the end of streaming";
        LmsPayload request = LmsCommand.MODE.request().add(on ? OperatingMode.STREAM_ALL : OperatingMode.ON_REQUEST);
        ask(name, LmsCommand.MODE, request, LONGEST_SCAN, MODE_TIMEOUT, reply -> {
            if (succeeded(reply, name)) {
                streams(on);
            }
        });
    }

    private void pauseStreaming(Runnable change) {
        boolean wasStreaming = isStreaming();
        if (wasStreaming) {
            setStreaming(false);
        }
        change.run();
        if (wasStreaming) {
            setStreaming(true);
        }
    }

    private void mode(String name, LmsPayload request) {
        ask(name, LmsCommand.MODE, request, OVERHEAD, MODE_TIMEOUT, reply -> succeeded(reply, name));
    }

    private void ask(String name, LmsCommand command, LmsPayload request, int replyLength, double timeout,
        Consumer<Telegram> then) {
        driver().ask(new LmsRequest(name, command, () -> request, replyLength, timeout, then));
    }

    private boolean succeeded(Telegram reply, String what) {
        if (reply.at(1) != 0) {
            listener.error("the LIDAR rejected " + what + " (result " + reply.at(1) + ")");
        }
        return reply.at(1) == 0;
    }
}
