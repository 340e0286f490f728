// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.nio.charset.StandardCharsets;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.mrlcomm.MrlFunction;
import org.SEAR.protocol.mrlcomm.MrlMessage;
import org.SEAR.protocol.mrlcomm.MrlReader;

/**
 * MyRobotLab's MrlComm, version 68. After a reset it sends a line of text and {@code AA 02 3A 44}. Then it sends its
 * board info once a second, and an acknowledgement after each command, immediately while time stands still. Its loop
 * takes a millisecond. Source: MyRobotLab's message schema and the behaviour of MrlComm.
 */
final class MrlCommFirmware implements Firmware {
    private static final double LOOP = 0.001;
    private static final int LOOP_MICROS = 1000;
    private static final int FREE_RAM = 1024;
    private static final int INFO_LOOPS = 1000;
    private static final String HELLO = String.format("%-63s", "MRLComm Reset.");
    private static final int OUT = 1;
    private static final int PULL_UP = 2;

    private final Host host;
    private final Pins pins;
    private final BoardModel board;
    private final MrlReader reader;
    private final MrlPinReports reports;
    private final MrlDevices devices;
    private boolean acknowledges;
    private boolean debug;
    private double now;
    private double start;
    private long loops;

    MrlCommFirmware(Host host) {
        this.host = host;
        this.pins = host.pins();
        this.board = pins.board();
        this.reader = new MrlReader(this::execute, function -> complain("unknown function " + function));
        this.reports = new MrlPinReports(host);
        this.devices = new MrlDevices(host, this::complain);
    }

    @Override
    public void setUp(double time, boolean silent) {
        reader.clear();
        softReset();
        acknowledges = true;
        now = time;
        start = time;
        loops = 0;
        if (!silent) {
            host.send(HELLO.getBytes(StandardCharsets.US_ASCII), time);
            send(MrlMessage.of(MrlFunction.PUBLISH_BEGIN).add(MrlMessage.VERSION));
        }
    }

    private void softReset() {
        reports.clear();
        devices.clear();
        debug = false;
    }

    @Override
    public void receive(int value, double time) {
        now = time;
        reader.accept(value);
    }

    @Override
    public void advance(double time) {
        while (start + (loops + 1) * LOOP <= time) {
            loops++;
            now = start + loops * LOOP;
            if (loops % INFO_LOOPS == 0) {
                reportBoard();
            }
            reports.loop(now);
            devices.loop(now);
        }
        now = time;
    }

    /**
     * True, because MyRobotLab's service waits for each acknowledgement in the script's thread, which makes time pass.
     */
    @Override
    public boolean answersAtOnce() {
        return true;
    }

    @Override
    public void introduce() {
        reportBoard();
    }

    private void send(MrlMessage.Builder message) {
        host.send(message.end().toBytes(), now);
    }

    private void complain(String text) {
        send(MrlMessage.of(MrlFunction.PUBLISH_ERROR).addText(text));
    }

    private void report(String text) {
        if (debug) {
            send(MrlMessage.of(MrlFunction.PUBLISH_DEBUG).addText(text));
        }
    }

    private void reportBoard() {
        send(MrlMessage.of(MrlFunction.PUBLISH_BOARD_INFO).add(MrlMessage.VERSION).add(board.getMrlType())
            .addShort(LOOP_MICROS).addShort(FREE_RAM).add(reports.size()).addList(devices.summary()));
    }

    private void execute(MrlMessage message) {
        host.understood();
        MrlFunction function = message.getFunction();
        if (!executeBoard(function, message) && !executePin(function, message)
            && !devices.execute(function, message, now)) {
            refuse(function);
        }
        if (acknowledges) {
            send(MrlMessage.of(MrlFunction.PUBLISH_ACK).add(function.getNumber()));
        }
    }

    private boolean executeBoard(MrlFunction function, MrlMessage message) {
        switch (function) {
            case GET_BOARD_INFO:
                reportBoard();
                return true;
            case SET_DEBUG:
                debug = message.getByte(0) != 0;
                return true;
            case SOFT_RESET:
                softReset();
                return true;
            case ENABLE_ACK:
                acknowledges = message.getByte(0) != 0;
                return true;
            case ECHO:
                send(MrlMessage.of(MrlFunction.PUBLISH_ECHO)
                    .addAll(message.getBytes(0, Float.BYTES + 1 + Float.BYTES)));
                return true;
            case CUSTOM_MSG:
            case SET_TRIGGER:
            case SET_DEBOUNCE:
            case SET_AREF:
            case SET_SERIAL_RATE:
            case MOTOR_ATTACH:
            case MOTOR_MOVE:
            case MOTOR_MOVE_TO:
                report(function + " not impl");
                return true;
            default:
                return false;
        }
    }

    private boolean executePin(MrlFunction function, MrlMessage message) {
        if (function == MrlFunction.DISABLE_PINS) {
            reports.clear();
            return true;
        }
        boolean known = function == MrlFunction.ENABLE_PIN || function == MrlFunction.DISABLE_PIN
            || function == MrlFunction.PIN_MODE
            || function == MrlFunction.ANALOG_WRITE || function == MrlFunction.DIGITAL_WRITE;
        if (!known) {
            return false;
        }
        int pin = message.getByte(0);
        if (!pins.has(pin)) {
            complain("no pin " + pin);
            return true;
        }
        switch (function) {
            case ENABLE_PIN:
                reports.enable(pin, message.getByte(1) != 0, message.getShort(2));
                break;
            case DISABLE_PIN:
                reports.disable(pin);
                break;
            case PIN_MODE:
                int mode = message.getByte(1);
                pins.setMode(pin, mode == OUT ? Pins.Mode.OUTPUT : mode == PULL_UP ? Pins.Mode.PULLUP
                    : Pins.Mode.INPUT);
                break;
            case ANALOG_WRITE:
                pins.writeDuty(pin, message.getByte(1));
                break;
            default:
                pins.write(pin, message.getByte(1) != 0);
                break;
        }
        return true;
    }

    /** Reports a function whose hardware can't be wired to the board. */
    private void refuse(MrlFunction function) {
        String text = function + ": nothing like that can be wired to this board";
        complain(text);
        host.warn("device", text);
    }

    @Override
    public String status() {
        return "MrlComm " + MrlMessage.VERSION + ", " + reports.size() + " pins read, " + devices.size() + " devices";
    }
}
