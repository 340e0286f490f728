package org.myrobotlab.service.lidar;

import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.myrobotlab.service.link.SerialLink;

/** An LMS2xx as its user sees it: scan modes, units, scans. Any thread; never blocks. */
public final class LmsDevice {
    private static final List<String> MODELS = Arrays.asList("LMS200", "LMS211", "LMS220", "LMS221", "LMS291");
    private static final double[][] VARIANTS = {{100, 1}, {100, 0.5}, {100, 0.25}, {180, 1}, {180, 0.5}};
    private static final double HUNDREDTHS = 100;
    private static final int OVERHEAD = 10;
    private static final int LONGEST_SCAN = 813;
    private static final int CONFIGURATION_AT = 1;
    private static final int SET_CONFIGURATION_AT = 2;
    /** A change of operating mode takes up to 3 s (telegram listing, chapter 4). */
    private static final double MODE_PATIENCE = 3;
    /** Writing the configuration takes up to 7 s; drivers wait longer. */
    private static final double WRITE_PATIENCE = 15;
    private static final double SHORT_PATIENCE = 1;

    /** Takes what happens at the device; called on the port's reader thread. */
    public interface Listener {
        void scan(LmsScan scan);

        void streaming(boolean on);

        void baud(int baud);

        /** @param spread degrees from first to last beam @param resolution degrees between beams */
        void scanMode(double spread, double resolution);

        void unit(boolean millimetres);

        void error(String message);

        void info(String message);
    }

    private final Listener listener;
    private SerialLink link;
    private LmsDriver driver;
    private volatile int measuringMode;
    private volatile double resolution = 1;
    private volatile boolean streaming;
    private volatile byte[] configuration;
    private volatile LmsScan lastScan;
    private String lastComplaint = "";

    public LmsDevice(Listener listener) {
        this.listener = listener;
    }

    /** Gives the device its port. Before anything else. */
    public void attach(SerialLink newLink) {
        link = newLink;
        driver = new LmsDriver(new Wire(), new Events());
    }

    /** @throws IllegalArgumentException that names the legal rates */
    public static int checkedBaud(int baud) {
        if (Stream.of(LmsDriver.BAUDS).noneMatch(known -> known[0] == baud)) {
            throw new IllegalArgumentException("LIDAR baud rate is " + baud + ", legal: "
                + Stream.of(LmsDriver.BAUDS).map(known -> String.valueOf(known[0])).collect(Collectors.joining(", ")));
        }
        return baud;
    }

    /** @throws IllegalArgumentException that names the legal models */
    public static String checkedModel(String model) {
        if (!MODELS.contains(model)) {
            throw new IllegalArgumentException("LIDAR model is \"" + model + "\", legal: " + MODELS);
        }
        return model;
    }

    /** Bytes from the port. */
    public void receive(byte[] bytes) {
        driver.receive(bytes);
    }

    /** Lets time-outs pass. */
    public void tick() {
        driver.tick();
    }

    /** The port was closed. */
    public void clear() {
        driver.clear();
        streaming = false;
        configuration = null;
    }

    /** The last scan; null before the first. */
    public LmsScan getLastScan() {
        return lastScan;
    }

    /** Asks the device for its configuration and its status: unit, measuring mode, fan, and whether it streams already. */
    public void learn() {
        learnConfiguration();
        ask("the request for the status", LmsTelegram.of(LmsTelegram.STATUS), LmsTelegram.STATUS_REPLY, LmsTelegram.STATUS_LENGTH + OVERHEAD,
            SHORT_PATIENCE, this::status);
    }

    private void status(byte[] reply) {
        fan(LmsTelegram.word(reply, LmsTelegram.STATUS_SPREAD), LmsTelegram.word(reply, LmsTelegram.STATUS_RESOLUTION));
        boolean streams = LmsTelegram.isStream(reply[LmsTelegram.STATUS_MODE]);
        if (streams != streaming) {
            streaming = streams;
            listener.streaming(streams);
        }
    }

    private void fan(int spread, int hundredths) {
        resolution = hundredths / HUNDREDTHS;
        listener.scanMode(spread, resolution);
    }

    private void learnConfiguration() {
        ask("the request for the configuration", LmsTelegram.of(LmsTelegram.GET_CONFIGURATION), LmsTelegram.CONFIGURATION_REPLY,
            LmsTelegram.CONFIGURATION_LENGTH, SHORT_PATIENCE, reply -> configured(reply, CONFIGURATION_AT));
    }

    private void configured(byte[] reply, int at) {
        byte[] block = Arrays.copyOfRange(reply, at, at + LmsTelegram.CONFIGURATION_LENGTH);
        if (at + LmsTelegram.CONFIGURATION_LENGTH > reply.length) {
            throw new IllegalArgumentException("configuration of " + reply.length + " bytes");
        }
        configuration = block;
        measuringMode = block[LmsTelegram.CONFIGURATION_MODE] & 0xFF;
        listener.unit(block[LmsTelegram.CONFIGURATION_UNIT] == 1);
    }

    /** Tells the device to talk at another rate and follows it. */
    public void setBaud(int baud) {
        int code = Stream.of(LmsDriver.BAUDS).filter(known -> known[0] == baud).findFirst().get()[1];
        ask("the change to " + baud + " baud", LmsTelegram.of(LmsTelegram.MODE, code), LmsTelegram.MODE_REPLY, OVERHEAD, MODE_PATIENCE, reply -> {
            if (succeeded(reply, "the change to " + baud + " baud")) {
                driver.changeBaud(baud);
                listener.baud(baud);
            }
        });
    }

    /** Sets the fan. @throws IllegalArgumentException that names the legal pairs */
    public void setVariant(int spread, double newResolution) {
        if (Stream.of(VARIANTS).noneMatch(known -> known[0] == spread && known[1] == newResolution)) {
            throw new IllegalArgumentException("scan mode is spread " + spread + ", resolution " + newResolution
                + ", legal: 100 with 1, 0.5 or 0.25; 180 with 1 or 0.5");
        }
        int hundredths = (int) Math.round(newResolution * HUNDREDTHS);
        pauseStreaming(() -> ask("scan mode " + spread + " degrees by " + newResolution, LmsTelegram.variant(spread, hundredths),
            LmsTelegram.VARIANT_REPLY, OVERHEAD + 3, MODE_PATIENCE, reply -> {
                int nowSpread = LmsTelegram.word(reply, 2);
                int nowResolution = LmsTelegram.word(reply, 4);
                fan(nowSpread, nowResolution);
                if (reply[1] != 1) {
                    listener.error("the LIDAR refused scan mode " + spread + ", " + newResolution + " and stays at " + nowSpread + ", "
                        + nowResolution / HUNDREDTHS);
                }
            }));
    }

    /** Sets the unit: installation mode, read the configuration, write it with the unit changed, back to measuring. */
    public void setUnit(boolean millimetres) {
        pauseStreaming(() -> {
            mode("installation mode", LmsTelegram.installationMode());
            learnConfiguration();
            driver.ask(new LmsRequest("the change of unit", () -> withUnit(millimetres), LmsTelegram.SET_CONFIGURATION_REPLY,
                LmsTelegram.CONFIGURATION_LENGTH, WRITE_PATIENCE, reply -> {
                    if (reply[1] == 1) {
                        configured(reply, SET_CONFIGURATION_AT);
                    } else {
                        listener.error("the LIDAR refused the change of unit");
                    }
                }));
            mode("measuring on request", LmsTelegram.of(LmsTelegram.MODE, LmsTelegram.ON_REQUEST));
        });
    }

    private byte[] withUnit(boolean millimetres) {
        if (configuration == null) {
            throw new IllegalStateException("the LIDAR did not tell its configuration");
        }
        byte[] block = configuration.clone();
        block[LmsTelegram.CONFIGURATION_UNIT] = (byte) (millimetres ? 1 : 0);
        return LmsTelegram.setConfiguration(block);
    }

    /** Asks for one scan. While streaming the next one comes anyway. */
    public void singleScan() {
        if (!streaming) {
            ask("a single scan", LmsTelegram.of(LmsTelegram.SCAN, 1), LmsTelegram.SCAN_REPLY, LONGEST_SCAN, SHORT_PATIENCE, this::scanned);
        }
    }

    private void scanned(byte[] body) {
        LmsScan scan = LmsReplies.scan(body, measuringMode, resolution, link.now());
        lastScan = scan;
        listener.scan(scan);
        String complaint = LmsReplies.complaint(body);
        if (!complaint.equals(lastComplaint)) {
            lastComplaint = complaint;
            listener.error(complaint.isEmpty() ? "the LIDAR has recovered" : complaint);
        }
    }

    /** Starts or stops scan after scan. */
    public void setStreaming(boolean on) {
        driver.ask(new LmsRequest(on ? "streaming" : "the end of streaming",
            () -> LmsTelegram.of(LmsTelegram.MODE, on ? LmsTelegram.STREAM_ALL : LmsTelegram.ON_REQUEST), LmsTelegram.MODE_REPLY,
            LONGEST_SCAN, MODE_PATIENCE, reply -> {
                if (succeeded(reply, on ? "streaming" : "the end of streaming")) {
                    streaming = on;
                    listener.streaming(on);
                }
            }));
    }

    private void pauseStreaming(Runnable change) {
        boolean wasStreaming = streaming;
        if (wasStreaming) {
            setStreaming(false);
        }
        change.run();
        if (wasStreaming) {
            setStreaming(true);
        }
    }

    private void mode(String name, byte[] body) {
        ask(name, body, LmsTelegram.MODE_REPLY, OVERHEAD, MODE_PATIENCE, reply -> succeeded(reply, name));
    }

    private void ask(String name, byte[] body, int reply, int replyLength, double patience, Consumer<byte[]> then) {
        driver.ask(new LmsRequest(name, () -> body, reply, replyLength, patience, then));
    }

    private boolean succeeded(byte[] reply, String what) {
        if (reply[1] != 0) {
            listener.error("the LIDAR did not take " + what + " (result " + reply[1] + ")");
        }
        return reply[1] == 0;
    }

    private final class Events implements LmsDriver.Events {
        @Override
        public void baud(int baud) {
            listener.baud(baud);
        }

        @Override
        public void scan(byte[] body) {
            scanned(body);
        }

        @Override
        public void error(String message) {
            listener.error(message);
        }

        @Override
        public void info(String message) {
            listener.info(message);
        }
    }

    private final class Wire implements LmsDriver.Line {
        @Override
        public void write(byte[] bytes) {
            link.write(bytes);
        }

        @Override
        public void setBaud(int baud) {
            link.setBaud(baud);
        }

        @Override
        public int getBaud() {
            return link.getBaud();
        }

        @Override
        public double now() {
            return link.now();
        }
    }
}
