// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.cola;

import java.util.Locale;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.RequestQueue;
import org.SEAR.devices.ScannerFirmware;
import org.SEAR.protocol.cola.ColaDialect;
import org.SEAR.protocol.cola.ColaReader;
import org.SEAR.protocol.cola.ColaTelegram;
import org.SEAR.sensors.LidarScan;

/**
 * Firmware of SICK's LMS1xx and TiM. It answers requests of CoLa A and B, each in its own dialect, and sends a stream
 * of scans. It measures continuously at its own rate; a request for a scan gets the newest one. {@link ColaCommands}
 * contains the requests. One client at a time.
 */
public final class ColaScanner extends ScannerFirmware {
    /** Delay between request and answer, seconds; real devices take a few milliseconds. */
    private static final double ANSWER = 0.001;
    /** Time without a byte after which an incomplete request is discarded, seconds. */
    private static final double TIMEOUT = 1;
    /** Longest request, bytes; real ones are below 100. */
    private static final int LONGEST = 1024;
    /** Time from the start of measuring to the first scan, seconds: with the motor running, and from standby. */
    private static final double LASER_ON = 1;
    private static final double SPIN_UP = 8;
    /** Tolerance for rounding errors in a number of scans. */
    private static final double SLACK = 1e-9;
    private static final double CIRCLE = 360;

    /** States as in STlms. */
    enum State {
        BOOTING(1), IDLE(3), ROTATED(4), PREPARING(5), MEASURING(7);

        final int code;

        State(int code) {
            this.code = code;
        }
    }

    private final ColaModel model;
    private final int baud;
    private final ScannerSettings delivered;
    private final RequestQueue<ColaTelegram> requests = new RequestQueue<>(events, time -> time + ANSWER, this::answer);
    private final ColaReader reader = new ColaReader(LONGEST, this::onTelegram);
    private final ColaCommands commands;
    private ScannerSettings saved;
    private ScannerSettings settings;
    private State state;
    private double poweredAt;
    private double lastByte;
    private ScanTelegram newest;
    private long telegrams;
    /** Incremented at each start and end of a stream or connection; events of earlier streams are ignored. */
    private int session;

    /**
     * Creates a device that has been on for a long time.
     *
     * @param spread range of angles, degrees
     * @param resolution angle between measurements, degrees
     * @param baud bit rate of its network, bits per second
     * @throws IllegalArgumentException unless the context's sensor is a LIDAR
     */
    ColaScanner(ColaModel model, double spread, double resolution, int baud, DeviceContext context) {
        super(model.lidar.withArticle(), context);
        this.model = model;
        this.baud = baud;
        this.delivered = ScannerSettings.of(model.rateWith(resolution), spread);
        this.commands = new ColaCommands(this, model);
        reset();
    }

    @Override
    public int getBaud() {
        return baud;
    }

    @Override
    public boolean hearsEveryBaud() {
        return true;
    }

    @Override
    public void receive(int value, double time) {
        advance(time);
        lastByte = time;
        if (state != State.BOOTING) {
            reader.accept(value);
        }
    }

    /** Ends login and stream, which belong to a connection. */
    @Override
    public void portClosed(double time) {
        advance(time);
        reader.clear();
        requests.dropWaiting();
        context.clearOutput();
        commands.logOut();
        session++;
    }

    @Override
    protected void forgetRequest() {
        reader.clear();
    }

    @Override
    public void advance(double time) {
        if (reader.isPending() && time > lastByte + TIMEOUT) {
            reader.clear();
        }
        events.runUntil(time);
    }

    @Override
    public void reset() {
        saved = delivered;
        start(0);
        state = State.MEASURING;
    }

    @Override
    public void powerOn(double time) {
        start(time);
        state = State.BOOTING;
        events.at(time + model.boot, t -> state = State.MEASURING);
    }

    private void start(double time) {
        events.clear();
        requests.clear();
        reader.clear();
        commands.logOut();
        settings = saved;
        poweredAt = time;
        lastByte = time;
        newest = null;
        telegrams = 0;
        session++;
    }

    @Override
    public boolean isStarting() {
        return state == State.BOOTING;
    }

    @Override
    public String title() {
        return model.lidar.withArticle();
    }

    @Override
    public String status() {
        return model.lidar.getName() + ": " + settings.beams() + " beams every "
            + settings.rate.resolution / ColaModel.TEN_THOUSANDTHS + " degrees, "
            + settings.rate.hertz() + " Hz, " + state.name().toLowerCase(Locale.ROOT)
            + (commands.isLoggedIn() ? ", logged in" : "");
    }

    private void onTelegram(ColaTelegram telegram) {
        requests.add(telegram, lastByte);
    }

    private void answer(ColaTelegram request, double time) {
        context.send(commands.answer(request, time), time);
        requests.done(time);
    }

    void understood() {
        context.understood();
    }

    ScannerSettings settings() {
        return settings;
    }

    /** Changes the settings from the next scan on. */
    void set(ScannerSettings changed) {
        settings = changed;
        newest = null;
    }

    /** Saves the settings for the next power-on. */
    void save() {
        saved = settings;
    }

    void toFactory() {
        saved = delivered;
        set(delivered);
    }

    void reboot(double time) {
        events.at(time, this::powerOn);
    }

    State state() {
        return state;
    }

    /** Seconds since power-on. */
    double upTime(double time) {
        return time - poweredAt;
    }

    void startMeasuring(double time) {
        if (state != State.IDLE && state != State.ROTATED) {
            return;
        }
        double ready = time + (state == State.IDLE ? SPIN_UP : LASER_ON);
        state = State.PREPARING;
        events.at(ready, t -> state = state == State.PREPARING ? State.MEASURING : state);
    }

    void stopMeasuring(State rest) {
        state = rest;
        newest = null;
    }

    /** Returns the answer with the newest scan; null unless measuring. */
    byte[] newestScan(ColaDialect dialect, double time) {
        return state == State.MEASURING ? encode(dialect, "sRA", time) : null;
    }

    private byte[] encode(ColaDialect dialect, String verb, double time) {
        double up = upTime(time);
        long number = (long) Math.floor(up * settings.rate.hertz() + SLACK);
        if (newest == null || newest.getNumber() != number) {
            newest = new ScanTelegram(model, settings, measure(poweredAt + number / settings.rate.hertz()),
                number, time);
        }
        return newest.encode(dialect, verb, telegrams++, number / settings.rate.hertz(), up, context.epochMillis());
    }

    /**
     * Measures the ranges of the settings, right to left, metres: takes a scan symmetric about the forward axis and
     * cuts it.
     *
     * @param end time at which the mirror passes the leftmost beam of the model, simulated seconds
     */
    private double[] measure(double end) {
        int skipped = skipped();
        LidarScan scan = source.scan(context.truth(), spread(skipped), settings.rate.degrees());
        double[] ranges = new double[settings.beams()];
        for (int i = 0; i < ranges.length; i++) {
            double early = (model.lidar.getWidestSpread() / 2 - scan.angle(skipped + i)) / CIRCLE
                / settings.rate.hertz();
            ranges[i] = source.range(context.truth(), scan, skipped + i, end - early);
        }
        return ranges;
    }

    /** Number of measurements of the symmetric scan to the right of the settings' first one. */
    private int skipped() {
        double step = settings.rate.degrees();
        double first = settings.firstAngle();
        double last = first + (settings.beams() - 1) * step;
        int skipped = (int) Math.max(0, Math.ceil((first + last) / step - SLACK));
        return 2 * (skipped * step - first) < step ? skipped + 1 : skipped;
    }

    /** Angle of the symmetric scan, degrees. */
    private double spread(int skipped) {
        return 2 * (skipped * settings.rate.degrees() - settings.firstAngle());
    }

    /** Starts a stream of every n-th scan in a dialect, with n from the settings; null stops it. */
    void stream(ColaDialect dialect, double time) {
        session++;
        if (dialect != null) {
            next(dialect, session, time);
        }
    }

    private void next(ColaDialect dialect, int stream, double time) {
        double rate = settings.rate.hertz() / settings.every();
        double due = poweredAt + (Math.floor(upTime(time) * rate + SLACK) + 1) / rate;
        if (state == State.MEASURING) {
            source.expect(due, spread(skipped()), settings.rate.degrees());
        }
        events.at(due, t -> {
            if (stream != session) {
                return;
            }
            if (state == State.MEASURING) {
                context.send(encode(dialect, "sSN", t), t);
            }
            next(dialect, stream, t);
        });
    }
}
