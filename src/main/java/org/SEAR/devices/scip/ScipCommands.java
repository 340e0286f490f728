// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.scip;

import java.util.Locale;
import org.SEAR.protocol.scip.HokuyoModel;
import org.SEAR.protocol.scip.ReplyWriter;
import org.SEAR.protocol.scip.ScanCommand;
import org.SEAR.protocol.scip.ScipStatus;

/**
 * Commands and their replies. An unknown command, or one not permitted at present, gets status 0E. Source: SCIP 2.0,
 * chapters 8 to 12.
 */
final class ScipCommands {
    private static final int MAX_STRING = 16;
    private static final int LETTERS = 2;
    private static final int DEFAULT_SPEED = 99;
    private static final int MAX_SLOWER = 10;
    private static final int BAUD_DIGITS = 6;

    private final Hokuyo device;
    private final HokuyoModel model;
    private final Scanner scanner;
    private boolean laser;
    private boolean sensitive;
    private boolean adjusting;

    ScipCommands(Hokuyo device, HokuyoModel model, Scanner scanner) {
        this.device = device;
        this.model = model;
        this.scanner = scanner;
    }

    /** Restores the state of power-on. */
    void toStart(double time) {
        scanner.setClockZero(time);
        laser = false;
        sensitive = false;
        adjusting = false;
        scanner.setSlower(0);
    }

    void laserOff() {
        laser = false;
    }

    String describe() {
        return "laser " + (laser ? "on" : "off") + (device.isStreaming() ? ", sending scans" : "")
            + (adjusting ? ", adjusting its clock" : "");
    }

    /** Runs the command of a line. */
    void execute(String line, double time) {
        int parameters = line.length() < LETTERS ? -1 : parameters(line.substring(0, LETTERS));
        String fault = parameters < 0 || adjusting && !isForAdjusting(line) ? ScipStatus.UNKNOWN
            : fault(line, LETTERS + parameters);
        if (parameters >= 0) {
            device.understood();
        }
        if (fault != null) {
            answer(line, fault, time);
            return;
        }
        switch (line.substring(0, LETTERS)) {
            case "VV":
                device.reply(version(line), time);
                break;
            case "PP":
                device.reply(parameters(line, new ReplyWriter(line, ScipStatus.OK)), time);
                break;
            case "II":
                device.reply(state(line, time), time);
                break;
            case "BM":
                boolean already = laser;
                laser = true;
                answer(line, already ? ScipStatus.ALREADY : ScipStatus.OK, time);
                break;
            case "QT":
                stop();
                answer(line, ScipStatus.OK, time);
                break;
            case "RS":
            case "RT":
                restart(line, time);
                break;
            case "TM":
                adjustTime(line, time);
                break;
            case "SS":
                changeBaud(line, time);
                break;
            case "CR":
                answer(line, changeSpeed(line.substring(LETTERS, LETTERS + 2)), time);
                break;
            case "HS":
                answer(line, changeSensitivity(line.charAt(LETTERS)), time);
                break;
            default:
                scan(line, time);
                break;
        }
    }

    /**
     * Whether a command is accepted while the clock is adjusted. A reset ends the adjustment; in a UTM-30LX {@code QT}
     * ends it, too. A URG-04LX answers {@code QT} with 0E, so that drivers send {@code TM2}.
     */
    private boolean isForAdjusting(String line) {
        return line.startsWith("TM") || line.startsWith("RS") || line.startsWith("RT") || line.startsWith("QT")
            && model == HokuyoModel.UTM_30LX;
    }

    /** Number of parameter characters of a command; negative if the command is unknown. */
    private static int parameters(String letters) {
        switch (letters) {
            case "VV":
            case "PP":
            case "II":
            case "BM":
            case "QT":
            case "RS":
            case "RT":
                return 0;
            case "TM":
            case "HS":
                return 1;
            case "CR":
                return 2;
            case "SS":
                return BAUD_DIGITS;
            case "MD":
            case "MS":
                return ScanCommand.STREAM_LENGTH - LETTERS;
            case "GD":
            case "GS":
                return ScanCommand.SINGLE_LENGTH - LETTERS;
            default:
                return -1;
        }
    }

    private static String fault(String line, int length) {
        if (line.length() < length) {
            return ScipStatus.TOO_SHORT;
        }
        String string = line.substring(length);
        if (string.length() > MAX_STRING + (string.startsWith(";") ? 1 : 0)) {
            return ScipStatus.LONG_STRING;
        }
        return string.chars().allMatch(each -> each >= ' ' && each <= '~') ? null : ScipStatus.BAD_STRING;
    }

    private void answer(String line, String status, double time) {
        device.reply(new ReplyWriter(line, status), time);
    }

    private ReplyWriter version(String line) {
        return new ReplyWriter(line, ScipStatus.OK).property("VEND", "Hokuyo Automatic Co.,Ltd.")
            .property("PROD", model.getProduct())
            .property("FIRM", model.getFirmware()).property("PROT", "SCIP 2.0").property("SERI", "H0000001");
    }

    private ReplyWriter parameters(String line, ReplyWriter reply) {
        return reply.property("MODL", model.getModelText()).property("DMIN", model.getLeast())
            .property("DMAX", model.getGreatest())
            .property("ARES", model.getSteps()).property("AMIN", model.getFirst()).property("AMAX", model.getLast())
            .property("AFRT", model.getFront()).property("SCAN", model.getTurns());
    }

    private ReplyWriter state(String line, double time) {
        ReplyWriter reply = new ReplyWriter(line, ScipStatus.OK).property("MODL", model.getModelText())
            .property("LASR", laser ? "ON" : "OFF");
        setting(reply, String.format(Locale.ROOT, "SCSP:Initial(%d[rpm])", scanner.getTurns()));
        reply.property("MESM", device.isStreaming() ? "Measuring by " + (sensitive ? "Sensitive" : "Normal")
            + " Mode" : "IDLE");
        if (device.isUsb()) {
            reply.property("SBPS", "USB only");
        } else {
            setting(reply, "SBPS:" + device.getBaud() + "[bps]");
        }
        return reply.property("TIME", String.format(Locale.ROOT, "%06X", scanner.clock(time) & 0xFFFFFF))
            .property("STAT", "Sensor works well.");
    }

    /** Appends a setting; a UTM-30LX omits the remark from the checksum. */
    private void setting(ReplyWriter reply, String text) {
        String whole = text + "<-Default setting by user";
        reply.counted(whole, model == HokuyoModel.UTM_30LX ? text : whole);
    }

    private void stop() {
        device.stopStream();
        laser = false;
        adjusting = false;
    }

    private void restart(String line, double time) {
        stop();
        scanner.setClockZero(time);
        if (line.startsWith("RS")) {
            scanner.setSlower(0);
            sensitive = false;
            device.replyAndSwitch(new ReplyWriter(line, ScipStatus.OK), device.powerOnBaud(), time);
        } else {
            answer(line, ScipStatus.OK, time);
        }
    }

    private void adjustTime(String line, double time) {
        switch (line.charAt(LETTERS)) {
            case '0':
                answer(line, adjusting ? ScipStatus.ALREADY : ScipStatus.OK, time);
                stop();
                adjusting = true;
                break;
            case '1':
                device.reply(adjusting
                    ? new ReplyWriter(line, ScipStatus.OK).time(scanner.clock(time))
                        : new ReplyWriter(line, ScipStatus.NOT_HERE), time);
                break;
            case '2':
                boolean on = adjusting;
                adjusting = false;
                answer(line, on ? ScipStatus.OK : ScipStatus.UNCHANGED, time);
                break;
            default:
                answer(line, ScipStatus.BAD_PARAMETER, time);
                break;
        }
    }

    private void changeBaud(String line, double time) {
        String digits = line.substring(LETTERS, LETTERS + BAUD_DIGITS);
        int wanted = digits.chars().allMatch(each -> each >= '0' && each <= '9') ? Integer.parseInt(digits) : -1;
        if (wanted < 0) {
            answer(line, ScipStatus.BAD_PARAMETER, time);
        } else if (device.isUsb()) {
            answer(line, ScipStatus.NOT_HERE, time);
        } else if (!model.getLidar().hasBaud(wanted)) {
            answer(line, ScipStatus.BAD_RATE, time);
        } else if (wanted == device.getBaud()) {
            answer(line, ScipStatus.UNCHANGED, time);
        } else {
            device.replyAndSwitch(new ReplyWriter(line, ScipStatus.OK), wanted, time);
        }
    }

    private String changeSpeed(String digits) {
        if (model == HokuyoModel.UTM_30LX) {
            return ScipStatus.NOT_HERE;
        }
        int wanted = digits.matches("[0-9]{2}") ? Integer.parseInt(digits) : -1;
        if (wanted < 0 || wanted > MAX_SLOWER && wanted != DEFAULT_SPEED) {
            return ScipStatus.BAD_PARAMETER;
        }
        int slower = wanted == DEFAULT_SPEED ? 0 : wanted;
        if (slower == scanner.getSlower()) {
            return ScipStatus.UNCHANGED;
        }
        scanner.setSlower(slower);
        return ScipStatus.OK;
    }

    private String changeSensitivity(char wanted) {
        if (wanted != '0' && wanted != '1') {
            return ScipStatus.BAD_PARAMETER;
        }
        boolean already = sensitive == (wanted == '1');
        sensitive = wanted == '1';
        return already ? ScipStatus.ALREADY : ScipStatus.OK;
    }

    private void scan(String line, double time) {
        String fault = ScanCommand.fault(line, model.getLastAsked());
        boolean stream = ScanCommand.isStream(line);
        if (fault != null) {
            answer(line, fault, time);
        } else if (stream) {
            laser = true;
            answer(line, ScipStatus.OK, time);
            device.startStream(ScanCommand.of(line), time);
        } else if (!laser) {
            answer(line, ScipStatus.LASER_OFF, time);
        } else {
            device.answerScan(line, ScanCommand.of(line), time);
        }
    }
}
