// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.scip;

import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.RequestQueue;
import org.SEAR.devices.ScannerFirmware;
import org.SEAR.protocol.scip.HokuyoModel;
import org.SEAR.protocol.scip.ReplyWriter;
import org.SEAR.protocol.scip.ScanCommand;
import org.SEAR.protocol.scip.ScipStatus;

/**
 * Firmware of a Hokuyo scanner with SCIP 2.0. It runs one command at a time: a line in, its echo and a reply out.
 * Streams of scans run meanwhile. {@link ScipCommands} contains the commands. Source: SCIP 2.0 specification
 * C-42-03320B.
 */
public final class Hokuyo extends ScannerFirmware {
    /** Longest line; a command has at most 15 characters, and a string of 16 after a semicolon. */
    private static final int LONGEST_LINE = 64;
    /** Delay between a command and its reply, seconds; undocumented, drivers wait 100 ms and more. */
    private static final double ANSWER = 0.001;
    /** Time from power-on until it rotates and takes commands, seconds; undocumented. */
    private static final double BOOT = 2;

    private final HokuyoModel model;
    private final int powerOnBaud;
    private final RequestQueue<String> requests;
    private final StringBuilder line = new StringBuilder();
    private final Scanner scanner;
    private final ScipCommands commands;
    private int baud;
    private double bootedAt;
    private int stream;
    private boolean streaming;

    /**
     * @param baud baud rate at power-on; {@link HokuyoModel#USB} at a USB port
     * @throws IllegalArgumentException unless the context's sensor is a LIDAR and the baud rate is one of the model's
     */
    public Hokuyo(HokuyoModel model, int baud, DeviceContext context) {
        super("a " + model.getName(), context);
        if (!model.getLidar().hasBaud(baud)) {
            throw new IllegalArgumentException(baud + " baud is not available on a " + model.getName());
        }
        this.model = model;
        this.powerOnBaud = baud;
        this.scanner = new Scanner(model, source, context);
        this.commands = new ScipCommands(this, model, scanner);
        this.requests = new RequestQueue<>(events, time -> Math.max(time + ANSWER, context.lineFreeAt()),
            commands::execute);
        reset();
    }

    @Override
    public int getBaud() {
        return baud;
    }

    @Override
    public boolean hearsEveryBaud() {
        return isUsb();
    }

    @Override
    public void receive(int value, double time) {
        advance(time);
        if (time < bootedAt) {
            return;
        }
        if (value != '\n' && value != '\r') {
            if (line.length() < LONGEST_LINE) {
                line.append((char) value);
            }
        } else if (line.length() > 0) {
            requests.add(line.toString(), time);
            line.setLength(0);
        }
    }

    @Override
    protected void forgetRequest() {
        line.setLength(0);
    }

    @Override
    public void reset() {
        start(0);
        bootedAt = 0;
    }

    @Override
    public void powerOn(double time) {
        start(time);
        bootedAt = time + BOOT;
    }

    private void start(double time) {
        baud = powerOnBaud;
        events.clear();
        requests.clear();
        line.setLength(0);
        stopStream();
        commands.toStart(time);
    }

    @Override
    public String title() {
        return model.getLidar().withArticle();
    }

    @Override
    public String status() {
        return model.getName() + ": " + commands.describe() + (isUsb() ? ", USB" : ", " + baud + " baud");
    }

    /** Sends the reply to the present command and continues with the next command. */
    void reply(ReplyWriter reply, double time) {
        context.send(reply.toBytes(), time);
        requests.done(time);
    }

    /** Sends the reply, then changes the baud rate when it has left the line. */
    void replyAndSwitch(ReplyWriter reply, int next, double time) {
        context.send(reply.toBytes(), time);
        events.at(Math.max(time, context.lineFreeAt()), t -> {
            baud = next;
            line.setLength(0);
            requests.done(t);
        });
    }

    void understood() {
        context.understood();
    }

    int powerOnBaud() {
        return powerOnBaud;
    }

    boolean isUsb() {
        return powerOnBaud == HokuyoModel.USB;
    }

    boolean isStreaming() {
        return streaming;
    }

    void stopStream() {
        stream++;
        streaming = false;
    }

    /** Measures one scan and sends it as the reply to the present command. */
    void answerScan(String echo, ScanCommand command, double time) {
        scanner.measure(command, time, events,
            (scan, end) -> reply(scan.write(new ReplyWriter(echo, ScipStatus.OK)), end));
    }

    /** Sends scans until their requested number is reached or {@link #stopStream}. */
    void startStream(ScanCommand command, double time) {
        int session = ++stream;
        streaming = true;
        cycle(session, command, command.getCount(), time);
    }

    /** Measures and sends one scan of a stream, then schedules the next; skips a scan while the line is busy. */
    private void cycle(int session, ScanCommand command, int left, double time) {
        scanner.measure(command, time, events, (scan, end) -> {
            if (session != stream) {
                return;
            }
            if (context.lineFreeAt() > end) {
                cycle(session, command, left, end);
                return;
            }
            int remaining = Math.max(0, left - 1);
            context.send(scan.write(new ReplyWriter(command.withCount(remaining).toString(), ScipStatus.SCAN))
                .toBytes(), end);
            if (command.getCount() > 0 && remaining == 0) {
                stopStream();
                commands.laserOff();
            } else {
                cycle(session, command, remaining, end + command.getInterval() * scanner.scanTime());
            }
        });
    }
}
