package org.SEAR.devices.lms;

import java.nio.charset.StandardCharsets;

/**
 * What each request does, and its reply. A request that the present mode does not permit, or that is unknown, is answered by 92h. Source: SICK
 * telegram listing, chapter 7.
 */
final class Commands {
    /** Status byte without warnings: LMS type 6. */
    static final int STATUS_OK = 0x10;

    private static final int RESET = 0x10;
    private static final int MODE = 0x20;
    private static final int SCAN = 0x30;
    private static final int STATUS = 0x31;
    private static final int ERRORS = 0x32;
    private static final int MEAN = 0x36;
    private static final int RANGE = 0x37;
    private static final int TYPE = 0x3A;
    private static final int VARIANT = 0x3B;
    private static final int MEAN_RANGE = 0x3F;
    private static final int PERMANENT_BAUD = 0x66;
    private static final int GET_CONFIGURATION = 0x74;
    private static final int SET_CONFIGURATION = 0x77;
    private static final int PIXELS = 0x7C;

    private static final int REPLY = 0x80;
    private static final int RESET_REPLY = 0x91;
    private static final int POWER_ON_REPLY = 0x90;
    private static final int NOT_PERMITTED = 0x92;

    private static final int INSTALLATION = 0x00;
    private static final int DIAGNOSTIC = 0x10;
    private static final int ON_REQUEST = 0x25;
    private static final byte[] PASSWORD = "SICK_LMS".getBytes(StandardCharsets.US_ASCII);

    private static final int MODE_DONE = 0;
    private static final int MODE_REFUSED = 1;
    private static final int MAX_MEAN = 250;
    private static final int MIN_MEAN = 2;

    private final Lms200 device;
    private final PowerOn powerOn;
    private Configuration configuration;
    private Variant variant;
    private Baud restartBaud;
    private boolean permanent;
    private int mode;

    Commands(Lms200 device, PowerOn powerOn) {
        this.device = device;
        this.powerOn = powerOn;
    }

    /** Back to what the device was delivered with. */
    void powerOn() {
        configuration = Configuration.ofFactory();
        restartBaud = Baud.ofRate(powerOn.baud);
        permanent = false;
        restart();
    }

    private void restart() {
        variant = powerOn.variant;
        mode = ON_REQUEST;
    }

    Variant variant() {
        return variant;
    }

    Configuration configuration() {
        return configuration;
    }

    String describe() {
        String unit = configuration.getUnit() == 0 ? "cm" : "mm";
        return variant.getSpread() + " degrees every " + variant.getResolution() / 100.0 + ", " + unit + ", mode " + Integer.toHexString(mode) + "h";
    }

    /** Carries out a request whose ACK has just been sent. */
    void execute(Telegram request, double time) {
        switch (request.getCommand()) {
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
                scan(request, time);
                break;
            case VARIANT:
                changeVariant(request, time);
                break;
            case SET_CONFIGURATION:
                configure(request, time);
                break;
            default:
                device.replyAfter(Timing.ANSWER, answer(request), time);
                break;
        }
    }

    /** Replies that only tell something, and those that are settled at once. */
    private byte[] answer(Telegram request) {
        int command = request.getCommand();
        Payload reply = new Payload(command + REPLY & 0xFF);
        switch (request.size() == 1 ? command : -command) {
            case STATUS:
                return StatusReply.of(powerOn.identity, mode, variant, configuration, device.baud(), permanent, STATUS_OK);
            case ERRORS:
                return reply.add(STATUS_OK).toBytes();
            case TYPE:
                return reply.text(powerOn.identity.getType()).add(STATUS_OK).toBytes();
            case GET_CONFIGURATION:
                configuration.writeTo(reply);
                return reply.add(STATUS_OK).toBytes();
            case -PERMANENT_BAUD:
                return keepBaud(request, reply);
            case -PIXELS:
                return mode == INSTALLATION ? reply.add(1).add(STATUS_OK).toBytes() : notPermitted();
            default:
                return notPermitted();
        }
    }

    private static byte[] notPermitted() {
        return new Payload(NOT_PERMITTED).add(STATUS_OK).toBytes();
    }

    private byte[] keepBaud(Telegram request, Payload reply) {
        if (request.size() != 2 || request.at(1) > 1) {
            return notPermitted();
        }
        permanent = request.at(1) == 1;
        restartBaud = permanent ? device.baud() : Baud.ofRate(powerOn.baud);
        return reply.add(request.at(1)).add(0).add(STATUS_OK).toBytes();
    }

    private void reset(Telegram request, double time) {
        if (request.size() != 1) {
            device.replyAfter(Timing.ANSWER, notPermitted(), time);
            return;
        }
        device.later(time + Timing.RESET, t -> {
            restart();
            byte[] greeting = new Payload(POWER_ON_REPLY).text(powerOn.identity.getType()).add(STATUS_OK).toBytes();
            device.restart(new Payload(RESET_REPLY).add(STATUS_OK).toBytes(), greeting, restartBaud, t);
        });
    }

    private void changeMode(Telegram request, double time) {
        int wanted = request.size() < 2 ? -1 : request.at(1);
        Baud baud = Baud.ofMode(wanted);
        if (baud != null && request.size() == 2) {
            device.later(time + Timing.CHANGE, t -> device.replyAndSwitch(modeReply(MODE_DONE), baud, t));
            return;
        }
        ScanKind stream = streamKind(request);
        boolean plain = request.size() == 2 && (wanted == ON_REQUEST || wanted == DIAGNOSTIC);
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
        return new Payload(MODE + REPLY).add(result).add(STATUS_OK).toBytes();
    }

    private static boolean isPassword(Telegram request) {
        if (request.size() != PASSWORD.length + 2 || request.at(1) != INSTALLATION) {
            return false;
        }
        for (int i = 0; i < PASSWORD.length; i++) {
            if (request.at(i + 2) != PASSWORD[i]) {
                return false;
            }
        }
        return true;
    }

    /** The stream that a 20h request asks for; null if it asks for none. */
    private ScanKind streamKind(Telegram request) {
        if (request.size() < 2) {
            return null;
        }
        switch (request.at(1)) {
            case 0x24:
                return request.size() == 2 ? ScanKind.ALL : null;
            case 0x2A:
                return request.size() == 2 ? ScanKind.PARTIAL : null;
            case 0x26:
                return mean(request, 2);
            case 0x27:
                return range(request, 2);
            case 0x28:
                return meanRange(request, 2);
            default:
                return null;
        }
    }

    private void scan(Telegram request, double time) {
        ScanKind kind = mode == ON_REQUEST ? scanKind(request) : null;
        if (kind == null) {
            device.replyAfter(Timing.ANSWER, notPermitted(), time);
        } else {
            device.measure(kind, time, device::reply);
        }
    }

    private ScanKind scanKind(Telegram request) {
        switch (request.getCommand()) {
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

    private static ScanKind single(int which) {
        switch (which) {
            case 0x01:
                return ScanKind.ALL;
            case 0x02:
                return ScanKind.MINIMUM;
            case 0x03:
                return ScanKind.CONTOUR;
            case 0x06:
                return ScanKind.every(2);
            case 0x07:
                return ScanKind.every(20);
            case 0x08:
                return ScanKind.PARTIAL;
            default:
                return null;
        }
    }

    private static ScanKind mean(Telegram request, int at) {
        boolean legal = request.size() == at + 1 && request.at(at) >= MIN_MEAN && request.at(at) <= MAX_MEAN;
        return legal ? ScanKind.mean(request.at(at)) : null;
    }

    private ScanKind range(Telegram request, int at) {
        boolean legal = request.size() == at + 4 && isRange(request.wordAt(at), request.wordAt(at + 2));
        return legal ? ScanKind.range(request.wordAt(at), request.wordAt(at + 2)) : null;
    }

    private ScanKind meanRange(Telegram request, int at) {
        boolean legal = request.size() == at + 5 && request.at(at) >= MIN_MEAN && request.at(at) <= MAX_MEAN
            && isRange(request.wordAt(at + 1), request.wordAt(at + 3));
        return legal ? ScanKind.meanRange(request.at(at), request.wordAt(at + 1), request.wordAt(at + 3)) : null;
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
            device.reply(new Payload(VARIANT + REPLY).add(wanted == null ? 0 : 1).word(variant.getSpread()).word(variant.getResolution())
                .add(STATUS_OK).toBytes(), t);
        });
    }

    private void configure(Telegram request, double time) {
        if (mode != INSTALLATION) {
            device.replyAfter(Timing.ANSWER, notPermitted(), time);
            return;
        }
        Configuration wanted = Configuration.of(request);
        device.later(time + Timing.WRITE, t -> {
            configuration = wanted == null ? configuration : wanted;
            Payload reply = new Payload(SET_CONFIGURATION + REPLY).add(wanted == null ? 0 : 1);
            configuration.writeTo(reply);
            device.reply(reply.add(STATUS_OK).toBytes(), t);
        });
    }
}
