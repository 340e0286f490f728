// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import java.util.Arrays;
import java.util.function.DoubleConsumer;
import java.util.function.IntToDoubleFunction;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.RequestQueue;
import org.SEAR.devices.ScannerFirmware;
import org.SEAR.geometry.TimeStep;
import org.SEAR.protocol.Uart;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.StatusByte;
import org.SEAR.protocol.lms.Telegram;
import org.SEAR.protocol.lms.TelegramReader;
import org.SEAR.protocol.lms.Variant;
import org.SEAR.sensors.LidarScan;

/**
 * Firmware of a SICK LMS200 and of its outdoor variants LMS221 and LMS291. It answers one request at a time: a telegram
 * in ({@link TelegramReader}), an ACK and a reply out. It also sends streams of scans. {@link LmsCommands} contains the
 * commands. Source: SICK telegram listing 8007954/Q501/2006-08-01.
 */
public final class Lms200 extends ScannerFirmware implements TelegramReader.Listener {
    /**
     * Longest pause between bytes of a request, seconds; a byte can seem late by the simulation step of its writing.
     */
    private static final double GAP = Timing.HOST_GAP + TimeStep.SECONDS;
    /** Baud telegrams of MyRobotLab's old driver; both have the checksum of 9600 baud. */
    private static final byte[] OLD_DRIVER_19200 = {0x02, 0x00, 0x02, 0x00, 0x20, 0x41, 0x52, 0x08};
    private static final byte[] OLD_DRIVER_38400 = {0x02, 0x00, 0x02, 0x00, 0x20, 0x40, 0x52, 0x08};
    private static final double CIRCLE = 360;

    private final PowerOnSettings powerOn;
    private final RequestQueue<Telegram> requests = new RequestQueue<>(events, time -> time + Timing.ACKNOWLEDGE,
        this::answer);
    private final TelegramReader reader;
    private final LmsCommands commands;
    private Baud baud;
    private boolean booting;
    private double lastByte;
    private double readUntil;
    private int stream;
    private int telegramIndex;
    /** When the last telegram of a stream has left the line, simulated seconds. */
    private double streamUntil;
    private int partial;

    /** @throws IllegalArgumentException unless the context's sensor is a LIDAR and the baud rate is one of an LMS200 */
    public Lms200(PowerOnSettings powerOn, DeviceContext context) {
        super("an LMS200", context);
        if (Baud.ofRate(powerOn.baud) == null) {
            throw new IllegalArgumentException("baud is " + powerOn.baud + ", legal for an LMS200: 9600, 19200, "
                + "38400, 500000");
        }
        this.powerOn = powerOn;
        this.reader = new TelegramReader(address -> true, this);
        this.commands = new LmsCommands(this, powerOn);
        reset();
    }

    @Override
    public int getBaud() {
        return baud.getRate();
    }

    @Override
    public void receive(int value, double time) {
        advance(time);
        lastByte = time;
        if (!booting) {
            readUntil = time;
            reader.accept(value);
        }
    }

    @Override
    protected void forgetRequest() {
        reader.clear();
    }

    @Override
    public void advance(double time) {
        double end = lastByte + GAP + Uart.seconds(1, baud.getRate());
        if (reader.isPending() && time > end) {
            events.runUntil(end);
            readUntil = end;
            reader.interrupt();
        }
        events.runUntil(time);
    }

    @Override
    public void reset() {
        commands.toFactory();
        start(Baud.ofRate(powerOn.baud));
    }

    @Override
    public void powerOn(double time) {
        boot(commands.powerOn(), time);
    }

    @Override
    public boolean isStarting() {
        return booting;
    }

    @Override
    public String title() {
        return "an " + powerOn.identity.getModel();
    }

    @Override
    public String status() {
        return powerOn.identity.getModel() + ": " + commands.describe() + ", " + baud.getRate() + " baud"
            + (booting ? ", starting" : "");
    }

    @Override
    public void onTelegram(Telegram telegram) {
        if (!isMine(telegram.getAddress())) {
            return;
        }
        context.understood();
        requests.add(telegram, readUntil);
    }

    @Override
    public void onWrongChecksum(byte[] bytes) {
        if (!isMine(bytes[1] & 0xFF)) {
            return;
        }
        if (powerOn.lenient && (Arrays.equals(bytes, OLD_DRIVER_19200) || Arrays.equals(bytes, OLD_DRIVER_38400))) {
            onTelegram(new Telegram(0, new byte[] {bytes[4], bytes[5]}));
        } else {
            events.at(readUntil + Timing.ACKNOWLEDGE, t -> acknowledge(Telegram.NAK, t));
        }
    }

    private boolean isMine(int address) {
        return address == 0 || address == powerOn.identity.getAddress();
    }

    private void answer(Telegram request, double time) {
        acknowledge(Telegram.ACK, time);
        commands.execute(request, time);
    }

    /** Sends ACK or NAK. It is due within 60 ms, so it cuts off a scan of the stream on the line. */
    private void acknowledge(int answer, double time) {
        if (streamUntil > time && streamUntil == context.lineFreeAt()) {
            context.cutOutput(time);
        }
        context.send(new byte[] {(byte) answer}, time);
    }

    /** Sends the reply to the present request and continues with the next request. */
    void reply(byte[] payload, double time) {
        send(payload, time);
        requests.done(time);
    }

    /** Sends the reply to the present request after a delay in seconds. */
    void replyAfter(double delay, byte[] payload, double time) {
        events.at(time + delay, t -> reply(payload, t));
    }

    /** Sends a telegram without ending a request. */
    void send(byte[] payload, double time) {
        context.send(new Telegram(powerOn.identity.getAddress() | Telegram.FROM_DEVICE, payload).toBytes(), time);
    }

    void later(double time, DoubleConsumer action) {
        events.at(time, action);
    }

    /** Sends the reply, then changes the baud rate when it has left the line. */
    void replyAndSwitch(byte[] payload, Baud next, double time) {
        send(payload, time);
        events.at(Math.max(time, context.lineFreeAt()), t -> {
            baud = next;
            reader.clear();
            requests.done(t);
        });
    }

    /** Restarts the device. It is silent until the power-on telegram, which has the new baud rate. */
    void restart(byte[] last, double time) {
        send(last, time);
        double down = Math.max(time, context.lineFreeAt());
        stopStream();
        requests.dropWaiting();
        events.clear();
        booting = true;
        events.at(down, t -> boot(commands.powerOn(), t));
    }

    private void boot(Baud speed, double time) {
        start(speed);
        booting = true;
        events.at(time + Timing.BOOT, up -> {
            booting = false;
            send(commands.greeting(), up);
        });
    }

    private void start(Baud speed) {
        baud = speed;
        events.clear();
        requests.clear();
        reader.clear();
        booting = false;
        lastByte = 0;
        stream++;
        streamUntil = 0;
        telegramIndex = 0;
        partial = 0;
    }

    Baud baud() {
        return baud;
    }

    /**
     * Measures the scans that a format needs, from the end of the present scan. The listener gets command, values and
     * status.
     */
    void measure(ScanFormat format, double time, MeasureListener listener) {
        Variant variant = commands.variant();
        ScanReply reply = new ScanReply(format, variant, commands.configuration());
        collect(format, reply, variant, Timing.scanEnd(time, format.scanTime(variant)), listener);
    }

    private void collect(ScanFormat format, ScanReply reply, Variant variant, double time, MeasureListener listener) {
        expect(variant, time);
        events.at(time, t -> {
            if (reply.add(scan(format, variant, t))) {
                int turn = (int) ((long) (t / Variant.TURN) & 0xFF);
                listener.measured(reply.toBytes(partial++ & 0xFF, turn, telegramIndex++ & 0xFF, StatusByte.OK), t);
            } else {
                collect(format, reply, variant, t + format.scanTime(variant), listener);
            }
        });
    }

    /**
     * Ranges of a scan that ends at a time, in which the mirror passes the leftmost beam. It measures a beam per degree
     * in each turn: of half degrees, those between whole degrees in the second turn, and likewise quarters.
     */
    private IntToDoubleFunction scan(ScanFormat format, Variant variant, double end) {
        LidarScan scan = source.scan(context.truth(), variant.getSpread(), degrees(variant));
        int turns = (int) Math.round(format.scanTime(variant) / Variant.TURN);
        double perBeam = Variant.TURN * degrees(variant) / CIRCLE;
        int last = scan.size() - 1;
        return beam -> source.range(context.truth(), scan, beam, end - (turns - 1 - beam % turns) * Variant.TURN
            - (last - beam) * perBeam);
    }

    private void expect(Variant variant, double time) {
        source.expect(time, variant.getSpread(), degrees(variant));
    }

    private static double degrees(Variant variant) {
        return variant.getResolution() / 100.0;
    }

    void stopStream() {
        stream++;
    }

    /** Sends scans of a format, as fast as mirror and line permit, until {@link #stopStream}. */
    void startStream(ScanFormat format, double time) {
        int session = ++stream;
        cycle(format, session, time);
    }

    private void cycle(ScanFormat format, int session, double time) {
        Variant variant = commands.variant();
        measure(format, time, (payload, t) -> {
            if (session != stream) {
                return;
            }
            double unit = format.scans * format.scanTime(variant);
            double period = unit;
            if (context.lineFreeAt() <= t) {
                send(payload, t);
                streamUntil = context.lineFreeAt();
                period = Timing.streamPeriod(payload.length + Telegram.FRAME_SIZE, baud.getRate(), unit);
            }
            double first = t + period - (format.scans - 1) * format.scanTime(variant);
            double begin = first - format.scanTime(variant) / 2;
            expect(variant, Timing.scanEnd(begin, format.scanTime(variant)));
            events.at(begin, next -> {
                if (session == stream) {
                    cycle(format, session, next);
                }
            });
        });
    }

    /** Receives measured values. */
    interface MeasureListener {
        void measured(byte[] payload, double time);
    }
}
