package org.myrobotlab.service;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.regex.Pattern;
import org.SEAR.protocol.Uart;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.nmea.Pmtk;
import org.SEAR.protocol.nmea.SentenceReader;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;
import org.SEAR.protocol.ubx.UbxReader;
import org.myrobotlab.serial.PortArrivals;
import org.myrobotlab.service.config.GPSConfig;
import org.myrobotlab.service.gps.GgaFix;
import org.myrobotlab.service.gps.PvtFix;
import org.myrobotlab.service.gps.ReceiverModel;
import org.myrobotlab.service.gps.UbxText;
import org.myrobotlab.service.link.OwnConfigService;
import org.myrobotlab.service.link.PanelFiles;
import org.myrobotlab.service.link.Reconnects;
import org.myrobotlab.service.link.SerialLink;
import org.myrobotlab.service.link.ServiceWarnings;

/**
 * Reads a GPS receiver that sends NMEA sentences or u-blox' UBX, real or simulated, on any port of MyRobotLab's Serial service.
 *
 * <pre>
 * gps = Runtime.start("roofGps", "GPS")
 * gps.addListener("publishGGAData", python.getName(), "onRoofGpsData")
 * gps.connect("/dev/SEAR_GPS_01")
 * </pre>
 *
 * <p>Sentences with a wrong check sum are left out. Loss of fix and loss of data are published as warnings, once. Any thread.
 */
public class GPS extends OwnConfigService<GPSConfig> implements Reconnects {
    private static final long serialVersionUID = 1L;
    private static final String PEER = "serial";
    /** What stands in a sentence between {@code $} and {@code *}. */
    private static final Pattern COMMAND = Pattern.compile("[ -~&&[^$*]]+");
    /** What the answer to the question for the firmware starts with. */
    private static final String FIRMWARE = "$" + Pmtk.RELEASE.body() + ",";
    /** Receivers send once a second; this long without a good sentence is a loss. Seconds. */
    private static final double SILENCE = 5;
    /** Pause between the command to change the rate and the change, beyond the command's own length. Seconds. */
    private static final double BEFORE_BAUD_CHANGE = 0.1;

    static {
        PanelFiles.install();
    }

    private final transient SentenceReader reader = new SentenceReader(this::onSentence);
    private final transient UbxReader frames = new UbxReader(this::onFrame, reader::accept);
    private transient SerialLink link;
    private transient double lastHeard;
    private transient double changeBaudAt = Double.POSITIVE_INFINITY;
    private transient int nextBaud;
    private transient volatile GgaFix lastFix;
    private transient boolean lastFixOfUbx;
    private transient boolean asked;
    private String firmware;
    private boolean connected;
    private boolean silent;
    private boolean fix;
    private long sentences;

    /** As MyRobotLab makes services. */
    public GPS(String name, String id) {
        super(name, id);
    }

    @Override
    protected Class<GPSConfig> configType() {
        return GPSConfig.class;
    }

    @Override
    public synchronized void startService() {
        super.startService();
        if (link == null) {
            link = new SerialLink((Serial) startPeer(PEER), this, this::tick, this::lost);
            Reconnects.restore(this, config.port, link);
        }
    }

    /**
     * Connects to the port the receiver is on, at the configured baud rate: unless set, 9600 for a NEO-M8N and 38400 for others.
     *
     * @param port the port's name, for example {@code "/dev/SEAR_GPS_01"} or {@code "COM3"}
     * @throws IOException if there is no such port, or it is in use
     * @example gps.connect("/dev/SEAR_GPS_01")
     */
    public void connect(String port) throws IOException {
        connect(port, config.baud);
    }

    /**
     * Connects to the port the receiver is on. When the first sentence has come, a receiver is asked for its firmware (unless the model is NMEA),
     * and the model becomes the one it names, if that is one of MediaTek's.
     *
     * @param port the port's name
     * @param baud 4800, 9600, 19200, 38400, 57600 or 115200; a NEO-M8N has 230400, 460800 and 921600 as well, the others 14400
     * @throws IOException if there is no such port, or it is in use
     * @example gps.connect("/dev/SEAR_GPS_01", 38400)
     */
    public void connect(String port, int baud) throws IOException {
        if (link == null) {
            startService();
        }
        model().checkedBaud(baud);
        disconnect();
        reader.reset();
        frames.reset();
        silent = false;
        fix = false;
        asked = false;
        firmware = null;
        link.connect(port, baud);
        config.baud = baud;
        config.port = port;
        lastHeard = link.timeOutNow();
        connected = true;
        broadcastState();
    }

    /**
     * Connects again to the port last used. A simulated port that comes back, and one of a restored configuration, needs no such call.
     *
     * @throws IOException if there was none, or it is gone, or in use
     * @example gps.reconnectSerial()
     */
    public void reconnectSerial() throws IOException {
        if (config.port == null) {
            throw new IOException(getName() + " was never connected: call connect(port) first");
        }
        connect(config.port, config.baud);
    }

    /**
     * Closes the port.
     *
     * @example gps.disconnect()
     */
    public void disconnect() {
        PortArrivals.forget(getName());
        if (link != null) {
            link.disconnect();
            if (connected) {
                gone();
            }
        }
    }

    private void gone() {
        connected = false;
        broadcastState();
    }

    /** Looks whether the port was closed by somebody else, and says so. */
    private void lost() {
        String port = link == null ? null : link.closeIfLost(() -> connected = false);
        if (port != null) {
            broadcastState();
            info("port %s was closed: %s connects again when a simulation has it, else by reconnectSerial()", port, getName());
        }
    }

    /**
     * Tells the receiver to talk at another rate ({@code $PMTK251}; a NEO-M8N by CFG-PRT) and follows it; not connected, or of model NMEA: the rate
     * of the port.
     *
     * @param baud 4800, 9600, 19200, 38400, 57600 or 115200; a NEO-M8N has 230400, 460800 and 921600 as well, the others 14400
     * @throws IllegalArgumentException that names those there are
     * @example gps.setBaud(38400)
     */
    public synchronized void setBaud(int baud) {
        int old = link != null && connected ? link.getBaud() : config.baud;
        config.baud = model().checkedBaud(baud);
        if (connected && !model().takesCommands()) {
            link.setBaud(baud);
        } else if (connected) {
            byte[] command = model().baudCommand(baud);
            send(command);
            nextBaud = baud;
            changeBaudAt = link.timeOutNow() + Uart.seconds(command.length, old) + BEFORE_BAUD_CHANGE;
        }
        broadcastState();
    }

    /**
     * Tells the receiver how many fixes a second to send ({@code $PMTK220}; a NEO-M8N by CFG-RATE). More sentences than the line carries are left out
     * by the receiver: at 9600 baud a NEO-M8N sends its six kinds once a second.
     *
     * @param hertz 0.1 to 5; to 10 for an MT3329 or a NEO-M8N
     * @throws IllegalArgumentException that says how many the model can
     * @throws IllegalStateException if it is not connected
     * @example gps.setRate(5)
     */
    public void setRate(double hertz) {
        send(model().rateCommand(hertz));
    }

    private ReceiverModel model() {
        return ReceiverModel.of(config.model);
    }

    /**
     * The receiver's type. While not connected, a configured baud rate that is the present model's as delivered becomes the new one's: 9600 for a
     * NEO-M8N, 38400 for others.
     *
     * @param model FV-M8 (FV_M8 as well), MT3301, MT3329 (these take PMTK commands), NEO-M8N (u-blox as well; takes UBX) or NMEA (never sent
     *     anything)
     * @throws IllegalArgumentException that names those there are
     * @example gps.setModel("FV-M8")
     */
    public void setModel(String model) {
        ReceiverModel old = model();
        ReceiverModel known = ReceiverModel.of(model);
        config.model = known.getLabel();
        if (!connected && config.baud == old.deliveredBaud()) {
            config.baud = known.deliveredBaud();
        }
        broadcastState();
    }

    /**
     * Sends a command of the receiver.
     *
     * @param body without {@code $} and check sum; {@code "PMTK220,200"} asks for five fixes a second
     * @throws IllegalArgumentException if it has what can't stand in a sentence
     * @throws IllegalStateException if it is not connected
     * @example gps.sendCommand("PMTK220,200")
     */
    public void sendCommand(String body) {
        if (body == null || !COMMAND.matcher(body).matches()) {
            throw new IllegalArgumentException("the command is " + (body == null ? null : "\"" + body + "\"")
                + ", legal: printable ASCII without $, * and check sum, which are added, as \"PMTK220,200\"");
        }
        send(Nmea.sentence(body).getBytes(StandardCharsets.US_ASCII));
    }

    /**
     * Sends a message to a u-blox receiver.
     *
     * @param hex class, number and payload, without what frames them; {@code "06 01 01 07 01"} switches NAV-PVT on
     * @throws IllegalArgumentException if these are not two bytes or more in hexadecimal
     * @throws IllegalStateException if it is not connected
     * @example gps.sendUbx("06 01 01 07 01")
     */
    public void sendUbx(String hex) {
        send(UbxText.frame(hex).toBytes());
    }

    private void send(byte[] bytes) {
        if (!isConnected()) {
            lost();
            throw new IllegalStateException(getName() + " is not connected: call connect(port) first");
        }
        link.write(bytes);
    }

    /**
     * Whether a port is open.
     *
     * @example print gps.isConnected()
     */
    public boolean isConnected() {
        return connected && !link.isLost();
    }

    /**
     * Names of the ports that there are, in order; published to the panel.
     *
     * @example print gps.getPortNames()
     */
    public List<String> getPortNames() {
        return link == null ? Collections.emptyList() : link.getPortNames();
    }

    /**
     * Whether the last GGA sentence, or NAV-PVT, had a position.
     *
     * @example print gps.hasFix()
     */
    public boolean hasFix() {
        return fix;
    }

    /**
     * The firmware as the receiver names it, for example {@code "MTK3301_1.0"} or {@code "EXT CORE 3.01 (107900)"}; None before it did.
     *
     * @example print gps.getFirmware()
     */
    public String getFirmware() {
        return firmware;
    }

    /**
     * The last GGA sentence, or NAV-PVT in its form; None before the first. It has latitude and longitude (decimal degrees, + north and east),
     * altitude (m), quality (0 = no fix), satellites, utc (hhmmss.sss) and tokens.
     *
     * @example fix = gps.getLastFix()
     */
    public GgaFix getLastFix() {
        return lastFix;
    }

    /**
     * Good sentences and UBX messages received since the service was made.
     *
     * @example print gps.getSentenceCount()
     */
    public long getSentenceCount() {
        return sentences;
    }

    /**
     * Sentences and UBX messages left out because they were damaged.
     *
     * @example print gps.getDamagedCount()
     */
    public long getDamagedCount() {
        return reader.getDamaged() + frames.getDamaged();
    }

    /**
     * The fields of a GGA sentence. Token 0 is {@code "$GPGGA"}, 2 the latitude as ddmm.mmmm and 4 the longitude as dddmm.mmmm, both negative in
     * the south and west ({@code "-08051.8999"}), 6 the quality of the fix, 9 the altitude in metres. A u-blox receiver's NAV-PVT comes in this form,
     * too; of both of one moment only the first.
     *
     * @example gps.addListener("publishGGAData", python.getName(), "onGuideGga")
     */
    public String[] publishGGAData(String[] tokens) {
        return tokens;
    }

    /**
     * The same as {@link #publishGGAData}, under the name that the dissertation's Listing 8 has.
     *
     * @example gps.addListener("publishGGADData", python.getName(), "onGuideGgad")
     */
    public String[] publishGGADData(String[] tokens) {
        return tokens;
    }

    /**
     * [latitude, longitude, altitude]: decimal degrees, + north and east, and metres.
     *
     * @example gps.addListener("publishGPS", python.getName(), "onGuidePosition")
     */
    public double[] publishGPS(double[] position) {
        return position;
    }

    /**
     * Each good sentence whole, from {@code $} to check sum.
     *
     * @example gps.addListener("publishSentence", python.getName(), "onGuideSentence")
     */
    public String publishSentence(String sentence) {
        return sentence;
    }

    @Override
    public void onBytes(byte[] bytes) {
        frames.feed(bytes);
    }

    private void onFrame(UbxFrame frame) {
        sentences++;
        heard();
        if (frame.getMessage() == UbxMessage.MON_VER) {
            firmware = UbxText.version(frame);
            broadcastState();
        } else if (frame.getMessage() == UbxMessage.ACK_NAK) {
            ServiceWarnings.publish(this, "%s refuses what it was told: %s", getName(), UbxText.refused(frame));
        } else if (frame.getMessage() == UbxMessage.NAV_PVT) {
            try {
                onGga(PvtFix.of(frame.getPayload()), true);
            } catch (IllegalArgumentException e) {
                ServiceWarnings.publish(this, "%s sent a NAV-PVT that makes no sense: %s", getName(), e.getMessage());
            }
        }
        if (!asked && connected) {
            askFirmware();
        }
    }

    private void onSentence(String sentence) {
        sentences++;
        heard();
        if (sentence.startsWith(FIRMWARE)) {
            onFirmware(sentence.substring(FIRMWARE.length()).split("[,*]", 2)[0]);
        } else if (!asked && connected) {
            askFirmware();
        }
        invoke("publishSentence", sentence);
        if (sentence.startsWith("GGA", 3)) {
            try {
                onGga(new GgaFix(sentence), false);
            } catch (IllegalArgumentException e) {
                ServiceWarnings.publish(this, "%s sent a GGA sentence that makes no sense: %s", getName(), sentence);
            }
        }
    }

    private void askFirmware() {
        asked = true;
        if (model().takesCommands()) {
            try {
                send(model().firmwareQuestion());
            } catch (IllegalStateException e) {
                log.info("{} can't be asked for its firmware: {}", getName(), e.getMessage());
            }
        }
    }

    private void onFirmware(String release) {
        firmware = release;
        ReceiverModel named = ReceiverModel.ofRelease(release);
        config.model = named == null ? config.model : named.getLabel();
        broadcastState();
    }

    private void heard() {
        lastHeard = link == null ? 0 : link.timeOutNow();
        if (silent) {
            silent = false;
            info("%s sends again", getName());
            broadcastState();
        }
    }

    /** A receiver may send a sentence and a message of the same moment. */
    private void onGga(GgaFix received, boolean ofUbx) {
        GgaFix before = lastFix;
        if (before != null && lastFixOfUbx != ofUbx && !received.utc.isEmpty() && received.utc.equals(before.utc)) {
            return;
        }
        lastFix = received;
        lastFixOfUbx = ofUbx;
        if (fix != received.hasFix()) {
            fix = received.hasFix();
            if (fix) {
                info("%s has a fix", getName());
            } else {
                ServiceWarnings.publish(this, "%s has lost its fix", getName());
            }
        }
        invoke("publishGGAData", (Object) received.tokens);
        invoke("publishGGADData", (Object) received.tokens);
        if (received.hasFix()) {
            invoke("publishGPS", new double[] {received.latitude, received.longitude, received.altitude});
        }
    }

    private synchronized void tick() {
        if (connected && link.timeOutNow() >= changeBaudAt) {
            changeBaudAt = Double.POSITIVE_INFINITY;
            link.setBaud(nextBaud);
        }
        if (connected && !silent && link.timeOutNow() - lastHeard > SILENCE) {
            silent = true;
            ServiceWarnings.publish(this, "no data from %s on port %s at %d baud for %s s: is it switched on, and is this its baud rate?", getName(),
                link.getPortName(), link.getBaud(), SILENCE);
            broadcastState();
        }
    }

    @Override
    public void onConnect(String portName) {
        log.info("{} connected to {}", getName(), portName);
    }

    /** The port is being closed, by this service or by whoever owns it. It may still be open now: {@link SerialLink} looks again. */
    @Override
    public void onDisconnect(String portName) {
        log.info("{} disconnected from {}", getName(), portName);
        lost();
    }

    @Override
    public synchronized void releaseService() {
        disconnect();
        releasePeer(PEER);
        super.releaseService();
    }
}
