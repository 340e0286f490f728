// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.rplidar;

import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.RequestQueue;
import org.SEAR.devices.ScannerFirmware;
import org.SEAR.protocol.rplidar.Health;
import org.SEAR.protocol.rplidar.Info;
import org.SEAR.protocol.rplidar.RequestReader;
import org.SEAR.protocol.rplidar.RplidarCommand;
import org.SEAR.protocol.rplidar.RplidarRequestPacket;

/**
 * Firmware 1.20 of an RPLIDAR A1M8. Its motor turns while there is power. On the real device the DTR line of the USB
 * adapter switches it, which a simulated port lacks. Requests for a motor's speed belong to other models; like unknown
 * requests, they get no answer. Source: Slamtec, interface protocol and application notes.
 */
public final class RplidarA1 extends ScannerFirmware {
    /** The only baud rate of its line, bits per second. */
    public static final int BAUD = 115200;
    /** Delay between a request and its answer, seconds; undocumented. */
    private static final double ANSWER = 0.001;
    /** Time after RESET without reception, seconds. */
    private static final double RESTART = 0.002;
    /** Time from power-on until it turns and receives requests, seconds; undocumented. */
    private static final double BOOT = 1;
    private static final int EXPRESS_PAYLOAD = 5;
    private static final byte[] SERIAL = {(byte) 0xEB, (byte) 0xB3, (byte) 0x99, (byte) 0xF6, (byte) 0xC9, (byte) 0xE5,
        (byte) 0x9A, (byte) 0xD2, (byte) 0xC5, (byte) 0xE5, (byte) 0x9C, (byte) 0xF7, 0x17, 0x61, 0x34, 0x12};
    private static final Info INFO = new Info(Info.A1M8, 1, 20, 0, SERIAL);
    /** Duration of a sample, us: 500 in standard scans, 250 in express scans. */
    private static final byte[] SAMPLE_RATE = {(byte) 0xF4, 0x01, (byte) 0xFA, 0x00};

    private final Head head;
    private final RequestQueue<RplidarRequestPacket> requests =
        new RequestQueue<>(events, this::answerAt, this::answer);
    private final RequestReader reader = new RequestReader(this::onRequest);
    private RplidarCommand scan;
    private int session;
    private double heardAt;
    private double deafUntil;

    /**
     * @param resolution degrees between two samples of a standard scan
     * @param nearest shortest measurable distance, metres
     * @throws IllegalArgumentException unless the context's sensor is a LIDAR
     */
    public RplidarA1(double resolution, double nearest, DeviceContext context) {
        super("an RPLIDAR", context);
        this.head = new Head(resolution, nearest, source, context);
    }

    @Override
    public int getBaud() {
        return BAUD;
    }

    @Override
    public void receive(int value, double time) {
        advance(time);
        if (time >= deafUntil) {
            heardAt = time;
            reader.accept(value);
        }
    }

    @Override
    protected void forgetRequest() {
        reader.clear();
    }

    @Override
    public void reset() {
        idle();
        deafUntil = 0;
    }

    @Override
    public void powerOn(double time) {
        idle();
        deafUntil = time + BOOT;
    }

    private void idle() {
        events.clear();
        requests.clear();
        reader.clear();
        stop();
    }

    private void stop() {
        session++;
        scan = null;
    }

    @Override
    public String title() {
        return "an RPLIDAR-A1";
    }

    @Override
    public String status() {
        String doing = scan == null ? "idle" : scan == RplidarCommand.EXPRESS_SCAN ? "express scan" : "scan";
        return "RPLIDAR-A1: " + doing + ", " + Math.round(head.turnsPerSecond() * 10) / 10.0 + " turns/s, "
            + BAUD + " baud";
    }

    private void onRequest(RplidarRequestPacket request) {
        requests.add(request, heardAt);
    }

    private double answerAt(double time) {
        return Math.max(time + ANSWER, context.lineFreeAt());
    }

    private void answer(RplidarRequestPacket request, double time) {
        execute(request, time);
        requests.done(time);
    }

    private void execute(RplidarRequestPacket request, double time) {
        RplidarCommand command = RplidarCommand.of(request.getCode());
        if (command == null || command == RplidarCommand.EXPRESS_SCAN
            && (request.size() != EXPRESS_PAYLOAD || request.at(0) != 0)) {
            return;
        }
        context.understood();
        stop();
        if (command.getDescriptor() != null) {
            context.send(command.getDescriptor().toBytes(), time);
        }
        switch (command) {
            case RESET:
                reader.clear();
                requests.dropWaiting();
                deafUntil = time + RESTART;
                break;
            case GET_INFO:
                context.send(INFO.toBytes(), time);
                break;
            case GET_HEALTH:
                context.send(new Health(Health.GOOD, 0).toBytes(), time);
                break;
            case GET_SAMPLE_RATE:
                context.send(SAMPLE_RATE, time);
                break;
            case SCAN:
            case FORCE_SCAN:
            case EXPRESS_SCAN:
                startScan(command, time);
                break;
            default:
                break;
        }
    }

    private void startScan(RplidarCommand command, double time) {
        scan = command;
        head.start(command == RplidarCommand.EXPRESS_SCAN, time + Head.BLOCK_SECONDS);
        send(command, session, true, time + Head.BLOCK_SECONDS);
    }

    /** Schedules the block measured by {@code time}, and all later blocks of the scan. */
    private void send(RplidarCommand command, int wanted, boolean first, double time) {
        events.at(time, t -> {
            if (wanted == session) {
                context.send(head.block(command == RplidarCommand.EXPRESS_SCAN, first, t), t);
                send(command, wanted, false, time + Head.BLOCK_SECONDS);
            }
        });
    }
}
