// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import java.nio.charset.StandardCharsets;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.Configuration;
import org.SEAR.protocol.lms.LmsCommand;
import org.SEAR.protocol.lms.LmsPayload;
import org.SEAR.protocol.lms.LmsStatus;
import org.SEAR.protocol.lms.OperatingMode;
import org.SEAR.protocol.lms.StatusByte;
import org.SEAR.protocol.lms.Telegram;
import org.SEAR.protocol.lms.Variant;

/**
 * Requests and their replies. A request that is unknown or not permitted in the present mode gets 92h. Source: SICK
 * telegram listing, chapter 7.
 */
final class LmsCommands {
    private static final byte[] PASSWORD = OperatingMode.PASSWORD.getBytes(StandardCharsets.US_ASCII);
    private static final int MODE_DONE = 0;
    private static final int MODE_REFUSED = 1;
    private static final int MAX_MEAN = 250;
    private static final int MIN_MEAN = 2;

    private final Lms200 device;
    private final PowerOnSettings powerOn;
    private Configuration configuration;
    private Variant variant;
    private Baud restartBaud;
    private boolean permanent;
    private int mode;

    LmsCommands(Lms200 device, PowerOnSettings powerOn) {
        this.device = device;
        this.powerOn = powerOn;
    }

    /** Restores the factory settings. */
    void toFactory() {
        configuration = Configuration.ofFactory().withMillimetres(powerOn.identity.isIndoor());
        restartBaud = Baud.ofRate(powerOn.baud);
        permanent = false;
        powerOn();
    }

    /**
     * Restores the volatile settings at power-on; the configuration and a permanent baud rate stay.
     *
     * @return the baud rate at start
     */
    Baud powerOn() {
        variant = powerOn.variant;
        mode = OperatingMode.ON_REQUEST;
        return restartBaud;
    }

    /** Telegram that it sends after its start. */
    byte[] greeting() {
        return new LmsPayload(LmsCommand.POWER_ON).text(powerOn.identity.getType()).add(StatusByte.OK).toBytes();
    }

    Variant variant() {
        return variant;
    }

    Configuration configuration() {
        return configuration;
    }

    String describe() {
        String unit = configuration.getUnit() == 0 ? "cm" : "mm";
        return variant.getSpread() + " degrees every " + variant.getResolution() / 100.0 + ", " + unit + ", mode "
            + Integer.toHexString(mode) + "h";
    }

    /** Runs a request whose ACK has just been sent. */
    void execute(Telegram request, double time) {
        LmsCommand command = LmsCommand.of(request.getCommand());
        if (command == null) {
            device.replyAfter(Timing.ANSWER, notPermitted(), time);
            return;
        }
        switch (command) {
            case RESET:
                reset(request, time);
                break;
            case MODE:
                changeMode(request, time);
                break;
            case SCAN:
            case MEAN:
            case RANGE:
            case MEAN_RANGE:
                scan(command, request, time);
                break;
            case VARIANT:
                changeVariant(request, time);
                break;
            case SET_CONFIGURATION:
                configure(request, time);
                break;
            case PERMANENT_BAUD:
                device.replyAfter(Timing.ANSWER, keepBaud(request), time);
                break;
            case PIXELS:
                device.replyAfter(Timing.ANSWER, setPixels(request), time);
                break;
            default:
                device.replyAfter(Timing.ANSWER, request.size() == 1 ? answer(command) : notPermitted(), time);
                break;
        }
    }

    /** Replies that only report something. */
    private byte[] answer(LmsCommand command) {
        LmsPayload reply = command.reply();
        switch (command) {
            case STATUS:
                return LmsStatus.encode(powerOn.identity, mode, variant, configuration, device.baud(), permanent,
                    StatusByte.OK);
            case TYPE:
                reply.text(powerOn.identity.getType());
                break;
            case GET_CONFIGURATION:
                reply.bytes(configuration.toBytes());
                break;
            default:
                break;
        }
        return reply.add(StatusByte.OK).toBytes();
    }

    private byte[] setPixels(Telegram request) {
        boolean legal = request.size() > 1 && mode == OperatingMode.INSTALLATION;
        return legal ? LmsCommand.PIXELS.reply().add(1).add(StatusByte.OK).toBytes() : notPermitted();
    }

    private static byte[] notPermitted() {
        return new LmsPayload(LmsCommand.NOT_PERMITTED).add(StatusByte.OK).toBytes();
    }

    private byte[] keepBaud(Telegram request) {
        if (request.size() != 2 || request.at(1) > 1) {
            return notPermitted();
        }
        permanent = request.at(1) == 1;
        restartBaud = permanent ? device.baud() : Baud.ofRate(powerOn.baud);
        return LmsCommand.PERMANENT_BAUD.reply().add(request.at(1)).add(0).add(StatusByte.OK).toBytes();
    }

    private void reset(Telegram request, double time) {
        if (request.size() != 1) {
            device.replyAfter(Timing.ANSWER, notPermitted(), time);
            return;
        }
        device.later(time + Timing.RESET,
            t -> device.restart(LmsCommand.RESET.reply().add(StatusByte.OK).toBytes(), t));
    }

    private void changeMode(Telegram request, double time) {
        int wanted = request.size() < 2 ? -1 : request.at(1);
        Baud baud = Baud.ofMode(wanted);
        if (baud != null && request.size() == 2) {
            device.later(time + Timing.CHANGE, t -> device.replyAndSwitch(modeReply(MODE_DONE), baud, t));
            return;
        }
        ScanFormat stream = streamKind(request);
        boolean plain = request.size() == 2
            && (wanted == OperatingMode.ON_REQUEST || wanted == OperatingMode.DIAGNOSTIC);
        if (stream == null && !plain && !isPassword(request)) {
            device.replyAfter(Timing.CHANGE, modeReply(MODE_REFUSED), time);
            return;
        }
        device.stopStream();
        device.later(time + Timing.CHANGE, t -> {
            mode = wanted;
            device.reply(modeReply(MODE_DONE), t);
            if (stream != null) {
                device.startStream(stream, t);
            }
        });
    }

    private static byte[] modeReply(int result) {
        return LmsCommand.MODE.reply().add(result).add(StatusByte.OK).toBytes();
    }

    private static boolean isPassword(Telegram request) {
        if (request.size() != PASSWORD.length + 2 || request.at(1) != OperatingMode.INSTALLATION) {
            return false;
        }
        for (int i = 0; i < PASSWORD.length; i++) {
            if (request.at(i + 2) != PASSWORD[i]) {
                return false;
            }
        }
        return true;
    }

    /** Format of the stream that a 20h request starts; null if it starts none. */
    private ScanFormat streamKind(Telegram request) {
        if (request.size() < 2) {
            return null;
        }
        switch (request.at(1)) {
            case OperatingMode.STREAM_ALL:
                return request.size() == 2 ? ScanFormat.ALL : null;
            case OperatingMode.STREAM_PARTIAL:
                return request.size() == 2 ? ScanFormat.PARTIAL : null;
            case OperatingMode.STREAM_MEAN:
                return mean(request, 2);
            case OperatingMode.STREAM_RANGE:
                return range(request, 2);
            case OperatingMode.STREAM_MEAN_RANGE:
                return meanRange(request, 2);
            default:
                return null;
        }
    }

    private void scan(LmsCommand command, Telegram request, double time) {
        ScanFormat format = mode == OperatingMode.ON_REQUEST ? scanFormat(command, request) : null;
        if (format == null) {
            device.replyAfter(Timing.ANSWER, notPermitted(), time);
        } else {
            device.measure(format, time, device::reply);
        }
    }

    private ScanFormat scanFormat(LmsCommand command, Telegram request) {
        switch (command) {
            case MEAN:
                return mean(request, 1);
            case RANGE:
                return range(request, 1);
            case MEAN_RANGE:
                return meanRange(request, 1);
            default:
                return request.size() == 2 ? single(request.at(1)) : null;
        }
    }

    private static ScanFormat single(int which) {
        switch (which) {
            case 0x01:
                return ScanFormat.ALL;
            case 0x02:
                return ScanFormat.MINIMUM;
            case 0x03:
                return ScanFormat.CONTOUR;
            case 0x06:
                return ScanFormat.every(2);
            case 0x07:
                return ScanFormat.every(20);
            case 0x08:
                return ScanFormat.PARTIAL;
            default:
                return null;
        }
    }

    private static ScanFormat mean(Telegram request, int at) {
        boolean legal = request.size() == at + 1 && request.at(at) >= MIN_MEAN && request.at(at) <= MAX_MEAN;
        return legal ? ScanFormat.mean(request.at(at)) : null;
    }

    private ScanFormat range(Telegram request, int at) {
        boolean legal = request.size() == at + 4 && isRange(request.wordAt(at), request.wordAt(at + 2));
        return legal ? ScanFormat.range(request.wordAt(at), request.wordAt(at + 2)) : null;
    }

    private ScanFormat meanRange(Telegram request, int at) {
        boolean legal = request.size() == at + 5 && request.at(at) >= MIN_MEAN && request.at(at) <= MAX_MEAN
            && isRange(request.wordAt(at + 1), request.wordAt(at + 3));
        return legal ? ScanFormat.meanRange(request.at(at), request.wordAt(at + 1), request.wordAt(at + 3)) : null;
    }

    private boolean isRange(int first, int last) {
        return first >= 1 && first <= last && last <= variant.getValues();
    }

    private void changeVariant(Telegram request, double time) {
        Variant wanted = request.size() == 5 ? Variant.of(request.wordAt(1), request.wordAt(3)) : null;
        device.later(time + Timing.CHANGE, t -> {
            if (wanted != null) {
                variant = wanted;
            }
            device.reply(LmsCommand.VARIANT.reply().add(wanted == null ? 0 : 1).word(variant.getSpread())
                .word(variant.getResolution()).add(StatusByte.OK).toBytes(), t);
        });
    }

    private void configure(Telegram request, double time) {
        if (mode != OperatingMode.INSTALLATION) {
            device.replyAfter(Timing.ANSWER, notPermitted(), time);
            return;
        }
        Configuration wanted = configuration.with(request);
        boolean taken = wanted != null && wanted.isLegal();
        device.later(time + Timing.WRITE, t -> {
            configuration = taken ? wanted : configuration;
            device.reply(LmsCommand.SET_CONFIGURATION.reply().add(taken ? 1 : 0).bytes(configuration.toBytes())
                .add(StatusByte.OK).toBytes(), t);
        });
    }
}
