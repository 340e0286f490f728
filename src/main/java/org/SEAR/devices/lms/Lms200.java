package org.SEAR.devices.lms;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.function.DoubleConsumer;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.SerialDevice;
import org.SEAR.devices.Timeline;
import org.SEAR.protocol.Uart;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.StatusByte;
import org.SEAR.protocol.lms.Telegram;
import org.SEAR.protocol.lms.TelegramReader;
import org.SEAR.protocol.lms.Variant;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.LidarSource;
import org.SEAR.geometry.TimeStep;

/**
 * The firmware of a SICK LMS200: telegrams in ({@link TelegramReader}), an ACK and a reply out, one request after the other, and streams of scans.
 * What the commands do stands in {@link Commands}. Source: SICK telegram listing 8007954/Q501/2006-08-01.
 */
public final class Lms200 implements SerialDevice, TelegramReader.Listener {
    /** Requests that wait while another is being answered; more are dropped. */
    private static final int MAX_WAITING = 16;
    /** A byte may look late by the step of the simulation in which the host wrote it. */
    private static final double GAP = Timing.HOST_GAP + TimeStep.SECONDS;
    /** MyRobotLab's old driver sends each baud telegram with the checksum of 9600 baud. */
    private static final byte[] OLD_DRIVER_19200 = {0x02, 0x00, 0x02, 0x00, 0x20, 0x41, 0x52, 0x08};
    private static final byte[] OLD_DRIVER_38400 = {0x02, 0x00, 0x02, 0x00, 0x20, 0x40, 0x52, 0x08};

    private final PowerOn powerOn;
    private final DeviceContext context;
    private final LidarSource source;
    private final Timeline timeline = new Timeline();
    private final Deque<Telegram> waiting = new ArrayDeque<>();
    private final TelegramReader reader;
    private final Commands commands;
    private Baud baud;
    private boolean busy;
    private boolean booting;
    private double lastByte;
    private double readUntil;
    private int stream;
    private int telegramIndex;
    private int partial;

    /** @throws IllegalArgumentException unless the context's sensor is a {@link LidarSource} and the baud rate one of an LMS200 */
    public Lms200(PowerOn powerOn, DeviceContext context) {
        if (!(context.sensor() instanceof LidarSource)) {
            throw new IllegalArgumentException("an LMS200 needs a LIDAR to scan with, not " + context.sensor());
        }
        if (Baud.ofRate(powerOn.baud) == null) {
            throw new IllegalArgumentException(powerOn.baud + " baud: an LMS200 has 9600, 19200, 38400 and 500000");
        }
        this.powerOn = powerOn;
        this.context = context;
        this.source = (LidarSource) context.sensor();
        this.reader = new TelegramReader(address -> true, this);
        this.commands = new Commands(this, powerOn);
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
    public void receiveGarbage(double time) {
        advance(time);
        reader.clear();
    }

    @Override
    public void advance(double time) {
        double end = lastByte + GAP + Uart.seconds(1, baud.getRate());
        if (reader.isPending() && time > end) {
            timeline.runUntil(end);
            readUntil = end;
            reader.interrupt();
        }
        timeline.runUntil(time);
    }

    @Override
    public void reset() {
        commands.powerOn();
        start(Baud.ofRate(powerOn.baud));
    }

    @Override
    public String status() {
        return "LMS200: " + commands.describe() + ", " + baud.getRate() + " baud" + (booting ? ", starting" : "");
    }

    @Override
    public void onTelegram(Telegram telegram) {
        if (isMine(telegram.getAddress()) && waiting.size() < MAX_WAITING) {
            waiting.add(telegram);
            serve(readUntil);
        }
    }

    @Override
    public void onWrongChecksum(byte[] bytes) {
        if (!isMine(bytes[1] & 0xFF)) {
            return;
        }
        if (powerOn.lenient && (Arrays.equals(bytes, OLD_DRIVER_19200) || Arrays.equals(bytes, OLD_DRIVER_38400))) {
            onTelegram(new Telegram(0, new byte[] {bytes[4], bytes[5]}));
        } else {
            timeline.at(readUntil + Timing.ACKNOWLEDGE, t -> context.send(new byte[] {Telegram.NAK}, t));
        }
    }

    private boolean isMine(int address) {
        return address == 0 || address == powerOn.identity.getAddress();
    }

    private void serve(double time) {
        if (busy || waiting.isEmpty()) {
            return;
        }
        busy = true;
        Telegram request = waiting.remove();
        timeline.at(time + Timing.ACKNOWLEDGE, t -> {
            context.send(new byte[] {Telegram.ACK}, t);
            commands.execute(request, t);
        });
    }

    /** Sends the reply to the present request and goes on to the next. */
    void reply(byte[] payload, double time) {
        send(payload, time);
        done(time);
    }

    /** Sends the reply to the present request after a delay. */
    void replyAfter(double delay, byte[] payload, double time) {
        timeline.at(time + delay, t -> reply(payload, t));
    }

    /** Sends a telegram, whoever asked for it. */
    void send(byte[] payload, double time) {
        context.send(new Telegram(powerOn.identity.getAddress() | Telegram.FROM_DEVICE, payload).toBytes(), time);
    }

    void later(double time, DoubleConsumer action) {
        timeline.at(time, action);
    }

    /** Sends the reply at the present speed and goes on at another once it has left. */
    void replyAndSwitch(byte[] payload, Baud next, double time) {
        send(payload, time);
        timeline.at(Math.max(time, context.lineFreeAt()), t -> {
            baud = next;
            reader.clear();
            done(t);
        });
    }

    /** Restarts: mute until the power-on telegram, which comes at the given speed. */
    void restart(byte[] last, byte[] powerOnPayload, Baud next, double time) {
        send(last, time);
        double down = Math.max(time, context.lineFreeAt());
        stopStream();
        waiting.clear();
        timeline.clear();
        booting = true;
        timeline.at(down, t -> {
            start(next);
            booting = true;
            timeline.at(t + Timing.BOOT, up -> {
                booting = false;
                send(powerOnPayload, up);
            });
        });
    }

    private void done(double time) {
        busy = false;
        serve(time);
    }

    private void start(Baud speed) {
        baud = speed;
        timeline.clear();
        waiting.clear();
        reader.clear();
        busy = false;
        booting = false;
        lastByte = 0;
        stream++;
        telegramIndex = 0;
        partial = 0;
    }

    Baud baud() {
        return baud;
    }

    /** Scans from the end of the scan under way on, as often as the kind asks for, then hands over command, values and status. */
    void measure(ScanKind kind, double time, MeasureListener listener) {
        Variant variant = commands.variant();
        ScanReply reply = new ScanReply(kind, variant, commands.configuration());
        collect(kind, reply, variant, Timing.scanEnd(time, kind.scanTime(variant)), listener);
    }

    private void collect(ScanKind kind, ScanReply reply, Variant variant, double time, MeasureListener listener) {
        timeline.at(time, t -> {
            if (reply.add(scan(variant))) {
                int turn = (int) ((long) (t / Variant.TURN) & 0xFF);
                listener.measured(reply.toBytes(partial++ & 0xFF, turn, telegramIndex++ & 0xFF, StatusByte.OK), t);
            } else {
                collect(kind, reply, variant, t + kind.scanTime(variant), listener);
            }
        });
    }

    private LidarScan scan(Variant variant) {
        return source.scan(context.truth(), variant.getSpread(), variant.getResolution() / 100.0);
    }

    void stopStream() {
        stream++;
    }

    /** Sends scans of that kind, as fast as mirror and line allow, until {@link #stopStream}. */
    void startStream(ScanKind kind, double time) {
        int session = ++stream;
        cycle(kind, session, time);
    }

    private void cycle(ScanKind kind, int session, double time) {
        Variant variant = commands.variant();
        measure(kind, time, (payload, t) -> {
            if (session != stream) {
                return;
            }
            double unit = kind.scans * kind.scanTime(variant);
            double period = unit;
            if (context.lineFreeAt() <= t) {
                send(payload, t);
                period = Timing.streamPeriod(payload.length + Telegram.FRAME_SIZE, baud.getRate(), unit);
            }
            double first = t + period - (kind.scans - 1) * kind.scanTime(variant);
            timeline.at(first - kind.scanTime(variant) / 2, next -> {
                if (session == stream) {
                    cycle(kind, session, next);
                }
            });
        });
    }

    /** Takes measured values. */
    interface MeasureListener {
        void measured(byte[] payload, double time);
    }
}
