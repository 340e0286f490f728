// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.cola;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.DoubleConsumer;
import org.SEAR.protocol.cola.ColaError;
import org.SEAR.protocol.cola.ColaException;
import org.SEAR.protocol.cola.ColaPayload;
import org.SEAR.protocol.cola.ColaTelegram;

/**
 * Table of requests with their actions and answers. Requests that change something need a login. Simulation thread.
 * Source: SICK's telegram listing, {@code sick_scan_xd}, recorded telegrams.
 */
final class ColaCommands {
    private static final int NO_CLIENT = 0;
    private static final int CLIENT = 3;
    /** Hashed passwords by access level. */
    private static final Map<Integer, Integer> PASSWORDS = Map.of(2, 0xB21ACE26, CLIENT, 0xF4724744, 4, 0x81BE23AA);
    /** Verb of the answer to each request. */
    private static final Map<String, String> ANSWERS = Map.of("sRN", "sRA", "sRI", "sRA", "sWN", "sWA", "sMN", "sAN",
        "sEN", "sEA");
    /** Events that accept a subscription but never occur here. */
    private static final Set<String> QUIET_EVENTS = Set.of("LFErec", "LIDoutputstate", "LIDinputstate",
        "LMDscandatamon");
    private static final int DONE = 1;
    private static final int TENTHS_OF_AN_HOUR = 360;
    private static final double MICROSECONDS = 1e6;
    private static final int FIELDS = 48;
    private static final int MADE_OF_SEGMENTS = 2;
    private static final int LONGEST_NAME = 16;
    private static final int WRONG_FREQUENCY = 1;
    private static final int WRONG_RESOLUTION = 2;
    private static final int WRONG_BOTH = 3;
    private static final int WRONG_AREA = 4;
    private static final int WRONG_OTHER = 5;

    /** Reads the values of a request and writes those of the answer. */
    private interface Action {
        void run(ColaTelegram in, ColaPayload out) throws ColaException;
    }

    private static final class Row {
        final int level;
        final Action action;

        Row(int level, Action action) {
            this.level = level;
            this.action = action;
        }
    }

    private final ColaScanner device;
    private final ColaModel model;
    private final Map<String, Row> rows = new HashMap<>();
    private int level;
    private double now;

    ColaCommands(ColaScanner device, ColaModel model) {
        this.device = device;
        this.model = model;
        login();
        measuring();
        scanning();
        fields();
        identity();
    }

    private void row(String request, int needed, Action action) {
        rows.put(request, new Row(needed, action));
    }

    /** Logs the client out. */
    void logOut() {
        level = NO_CLIENT;
    }

    boolean isLoggedIn() {
        return level > NO_CLIENT;
    }

    /** Returns the framed answer to a request. */
    byte[] answer(ColaTelegram request, double time) {
        now = time;
        String verb = ANSWERS.get(request.getVerb());
        if (verb == null) {
            return ColaError.UNKNOWN_COMMAND.telegram(request.getDialect());
        }
        device.understood();
        if (request.getName().equals("LMDscandata") && request.getVerb().equals("sRN")) {
            byte[] scan = device.newestScan(request.getDialect(), time);
            return scan != null ? scan : ColaError.CONDITION_FAILED.telegram(request.getDialect());
        }
        try {
            Row row = find(request);
            ColaPayload out = new ColaPayload(request.getDialect()).begin(verb, request.getName());
            row.action.run(request, out);
            return out.toTelegram();
        } catch (ColaException e) {
            return e.getError().telegram(request.getDialect());
        }
    }

    private Row find(ColaTelegram request) throws ColaException {
        boolean method = request.getVerb().equals("sMN");
        Row row = rows.get(request.getVerb() + " " + request.getName());
        if (row == null && request.getVerb().equals("sEN")) {
            throw new ColaException(ColaError.UNKNOWN_EVENT);
        }
        if (row == null) {
            throw new ColaException(method ? ColaError.UNKNOWN_METHOD : ColaError.UNKNOWN_VARIABLE);
        }
        if (level < row.level) {
            throw new ColaException(method ? ColaError.ACCESS_DENIED : ColaError.WRITE_ACCESS_DENIED);
        }
        return row;
    }

    private void login() {
        row("sMN SetAccessMode", NO_CLIENT, (in, out) -> {
            int wanted = in.u1();
            Integer password = PASSWORDS.get(wanted);
            boolean right = password != null && password == in.i4();
            level = right ? wanted : level;
            out.u1(right ? DONE : 0);
        });
        row("sMN Run", NO_CLIENT, (in, out) -> {
            level = NO_CLIENT;
            out.u1(DONE);
        });
        row("sWN EIHstCola", NO_CLIENT, (in, out) -> in.u1());
        row("sMN mEEwriteall", CLIENT, (in, out) -> {
            device.save();
            out.u1(DONE);
        });
        row("sMN mSCloadfacdef", CLIENT, (in, out) -> device.toFactory());
        row("sMN mSCreboot", CLIENT, (in, out) -> device.reboot(now));
        row("sMN LSPsetdatetime", CLIENT, (in, out) -> out.u1(DONE));
    }

    private void measuring() {
        row("sMN LMCstartmeas", NO_CLIENT, (in, out) -> out.u1(started(device::startMeasuring)));
        row("sMN LMCstopmeas", NO_CLIENT,
            (in, out) -> out.u1(started(time -> device.stopMeasuring(ColaScanner.State.ROTATED))));
        row("sMN LMCstandby", NO_CLIENT,
            (in, out) -> out.u1(started(time -> device.stopMeasuring(ColaScanner.State.IDLE))));
        row("sEN LMDscandata", NO_CLIENT, (in, out) -> {
            boolean on = in.u1() != 0;
            out.u1(on ? 1 : 0);
            device.stream(on ? in.getDialect() : null, now);
        });
        for (String event : QUIET_EVENTS) {
            row("sEN " + event, NO_CLIENT, (in, out) -> out.u1(in.u1()));
        }
        row("sRN STlms", NO_CLIENT, (in, out) -> {
            int up = (int) device.upTime(now);
            String clock = String.format(Locale.ROOT, "%02d:%02d:%02d", up / 3600 % 24, up / 60 % 60, up % 60);
            out.u2(device.state().code).u1(0).text(clock).text("01.01.1970").u1(0).u1(0).u1(0);
        });
        // four unconnected inputs, and no time of a change
        row("sRN LIDinputstate", NO_CLIENT, (in, out) -> out.u2(0).i4((int) (long) (device.upTime(now) * MICROSECONDS))
            .u1(0).u1(0).u1(0).u1(0).u2(0));
        row("sRN SCdevicestate", NO_CLIENT, (in, out) -> out.u1(device.state() == ColaScanner.State.MEASURING ? 1 : 0));
    }

    /** Runs a change of the state and returns 0; returns 1 without a login. */
    private int started(DoubleConsumer change) {
        if (level < CLIENT) {
            return 1;
        }
        change.accept(now);
        return 0;
    }

    private void scanning() {
        row("sRN LMPscancfg", NO_CLIENT, (in, out) -> writeScanConfiguration(out));
        if (model.scanConfigurable) {
            row("sMN mLMPsetscancfg", CLIENT, (in, out) -> {
                out.u1(setRate(in.i4(), in.u2(), in.i4(), in.i4(), in.i4()));
                writeScanConfiguration(out);
            });
        }
        row("sRN LMPoutputRange", NO_CLIENT, (in, out) -> out.u2(1).i4(settings().rate.resolution).i4(settings().start)
            .i4(settings().stop));
        row("sWN LMPoutputRange", CLIENT, (in, out) -> {
            boolean one = in.u2() == 1;
            int resolution = in.i4();
            if (!one || resolution != settings().rate.resolution && model.rates.stream()
                .noneMatch(rate -> rate.resolution == resolution)) {
                throw new ColaException(ColaError.INVALID_DATA);
            }
            device.set(settings().withAngles(model, in.i4(), in.i4()));
        });
        row("sRN LMDscandatacfg", NO_CLIENT, (in, out) -> settings().writeContent(out));
        row("sWN LMDscandatacfg", CLIENT, (in, out) -> device.set(settings().withContent(in)));
    }

    private ScannerSettings settings() {
        return device.settings();
    }

    private void writeScanConfiguration(ColaPayload out) {
        out.i4(settings().rate.frequency).u2(1).i4(settings().rate.resolution).i4(model.firstAngle).i4(model.lastAngle);
    }

    /**
     * Sets frequency and resolution. The angles must be within the model's range and have no effect; LMPoutputRange
     * sets the transmitted angles.
     */
    private int setRate(int frequency, int sectors, int resolution, int start, int stop) {
        if (sectors != 1) {
            return WRONG_OTHER;
        }
        if (start < model.firstAngle || stop > model.lastAngle || start >= stop) {
            return WRONG_AREA;
        }
        boolean known = false;
        boolean fits = false;
        for (ColaModel.ScanRate rate : model.rates) {
            known |= rate.frequency == frequency;
            fits |= rate.resolution == resolution;
            if (rate.frequency == frequency && rate.resolution == resolution) {
                device.set(settings().withRate(rate));
                return 0;
            }
        }
        return known == fits ? WRONG_BOTH : known ? WRONG_RESOLUTION : WRONG_FREQUENCY;
    }

    /** Monitoring fields. None is configured, so they have no segments, as in SICK's own emulator. */
    private void fields() {
        for (int i = 1; i <= FIELDS; i++) {
            int number = i;
            row(String.format(Locale.ROOT, "sRN field%03d", number - 1), NO_CLIENT, (in, out) -> out.real(1).real(0)
                .i4(settings().rate.resolution)
                .i4(model.firstAngle).u1(MADE_OF_SEGMENTS).u1(number).u2(1).u2(0).u2(0).u2(0).u2(0).u2(1)
                .text(String.format(Locale.ROOT, "Field%03d", number)).u2(0));
        }
    }

    private void identity() {
        row("sRN DeviceIdent", NO_CLIENT, (in, out) -> out.text(model.type).text(model.version));
        row("sRI 0", NO_CLIENT, (in, out) -> out.text(model.type).text(model.version));
        row("sRN FirmwareVersion", NO_CLIENT,
            (in, out) -> out.text(model.version.substring(0, model.version.indexOf('-'))));
        row("sRN SerialNumber", NO_CLIENT, (in, out) -> out.text(String.valueOf(ScanTelegram.SERIAL_NUMBER)));
        row("sRN LocationName", NO_CLIENT, (in, out) -> out.text(settings().name));
        row("sWN LocationName", CLIENT, (in, out) -> {
            String name = in.text();
            if (name.length() > LONGEST_NAME || !name.matches("[ -~]*")) {
                throw new ColaException(ColaError.INVALID_DATA);
            }
            device.set(settings().withName(name));
        });
        row("sRN ODoprh", NO_CLIENT, (in, out) -> out.i4((int) (device.upTime(now) / TENTHS_OF_AN_HOUR)));
        row("sRN ODpwrc", NO_CLIENT, (in, out) -> out.i4(1));
    }
}
