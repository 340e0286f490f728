package org.myrobotlab.service;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.SEAR.protocol.Uart;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.nmea.Pmtk;
import org.SEAR.protocol.nmea.SentenceReader;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.GPSConfig;
import org.myrobotlab.service.gps.GgaFix;
import org.myrobotlab.service.interfaces.SerialDataListener;
import org.myrobotlab.service.link.PanelFiles;
import org.myrobotlab.service.link.SerialLink;
import org.myrobotlab.service.link.Warnings;

/**
 * Reads a GPS receiver that sends NMEA sentences, real or simulated, on any port of MyRobotLab's Serial service.
 *
 * <pre>
 * gps = Runtime.start("roofGps", "GPS")
 * gps.addListener("publishGGAData", python.getName(), "onRoofGpsData")
 * gps.connect("/dev/SEAR_GPS_01")
 * </pre>
 *
 * <p>Sentences with a wrong check sum are left out. Loss of fix and loss of data are published as warnings, once. Any thread.
 */
public class GPS extends Service<GPSConfig> implements SerialDataListener {
    private static final long serialVersionUID = 1L;
    private static final String PEER = "serial";
    private static final List<String> MODELS = Arrays.asList("FV-M8", "MT3301", "MT3329", "NMEA");
    private static final String PLAIN = "NMEA";
    /** What the answer to the question for the firmware starts with. */
    private static final String FIRMWARE = "$" + Pmtk.RELEASE.body() + ",";
    /** Receivers send once a second; this long without a good sentence is a loss. Seconds. */
    private static final double SILENCE = 5;
    /** Pause between the command to change the rate and the change, beyond the command's own length. Seconds. */
    private static final double BEFORE_BAUD_CHANGE = 0.1;

    static {
        PanelFiles.install(GPS.class);
    }

    private final transient SentenceReader reader = new SentenceReader(this::onSentence);
    private transient SerialLink link;
    private transient double lastHeard;
    private transient double changeBaudAt = Double.POSITIVE_INFINITY;
    private transient int nextBaud;
    private transient volatile GgaFix lastFix;
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
    public synchronized void startService() {
        super.startService();
        if (link == null) {
            link = new SerialLink((Serial) startPeer(PEER), this, this::tick, this::lost);
        }
    }

    /**
     * Connects to the port the receiver is on, at the configured baud rate, 38400 unless set.
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
     * and the model becomes the one it names.
     *
     * @param port the port's name
     * @param baud 4800, 9600, 14400, 19200, 38400, 57600 or 115200
     * @throws IOException if there is no such port, or it is in use
     * @example gps.connect("/dev/SEAR_GPS_01", 38400)
     */
    public void connect(String port, int baud) throws IOException {
        if (link == null) {
            startService();
        }
        checkedBaud(baud);
        disconnect();
        reader.reset();
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
     * Connects again to the port last used.
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
    private synchronized void lost() {
        if (connected && link.isLost()) {
            String port = link.getPortName();
            gone();
            info("port %s was closed: reconnectSerial() when it is back", port);
            link.close();
        }
    }

    /**
     * Tells the receiver to talk at another rate ({@code $PMTK251}) and follows it; not connected, or of model NMEA: the rate of the port.
     *
     * @param baud 4800, 9600, 14400, 19200, 38400, 57600 or 115200
     * @throws IllegalArgumentException that names those there are
     * @example gps.setBaud(38400)
     */
    public synchronized void setBaud(int baud) {
        int old = link != null && connected ? link.getBaud() : config.baud;
        config.baud = checkedBaud(baud);
        if (connected && PLAIN.equals(config.model)) {
            link.setBaud(baud);
        } else if (connected) {
            String command = Nmea.sentence(Pmtk.SET_BAUD.body(baud));
            send(command);
            nextBaud = baud;
            changeBaudAt = link.timeOutNow() + Uart.seconds(command.length(), old) + BEFORE_BAUD_CHANGE;
        }
        broadcastState();
    }

    private static int checkedBaud(int baud) {
        if (!Pmtk.BAUDS.contains(baud)) {
            throw new IllegalArgumentException("GPS baud rate is " + baud + ", legal: " + Pmtk.BAUDS);
        }
        return baud;
    }

    /**
     * The receiver's type.
     *
     * @param model FV-M8 (FV_M8 as well), MT3301, MT3329 (these take PMTK commands) or NMEA (never sent anything)
     * @throws IllegalArgumentException that names those there are
     * @example gps.setModel("FV-M8")
     */
    public void setModel(String model) {
        String known = model == null ? null : model.replace('_', '-');
        if (!MODELS.contains(known)) {
            throw new IllegalArgumentException("GPS model is \"" + model + "\", legal: " + MODELS);
        }
        config.model = known;
        broadcastState();
    }

    /**
     * Sends a command of the receiver.
     *
     * @param body without {@code $} and check sum; {@code "PMTK220,200"} asks for five fixes a second
     * @throws IllegalStateException if it is not connected
     * @example gps.sendCommand("PMTK220,200")
     */
    public void sendCommand(String body) {
        send(Nmea.sentence(body));
    }

    private void send(String sentence) {
        if (!isConnected()) {
            lost();
            throw new IllegalStateException(getName() + " is not connected: call connect(port) first");
        }
        link.write(sentence.getBytes(StandardCharsets.US_ASCII));
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
     * Whether the last GGA sentence had a position.
     *
     * @example print gps.hasFix()
     */
    public boolean hasFix() {
        return fix;
    }

    /**
     * The firmware as the receiver names it, for example {@code "MTK3301_1.0"}; None before it did.
     *
     * @example print gps.getFirmware()
     */
    public String getFirmware() {
        return firmware;
    }

    /**
     * The last GGA sentence; None before the first. It has latitude and longitude (decimal degrees, + north and east), altitude (m), quality
     * (0 = no fix), satellites, utc (hhmmss.sss) and tokens.
     *
     * @example fix = gps.getLastFix()
     */
    public GgaFix getLastFix() {
        return lastFix;
    }

    /**
     * Good sentences received since the service was made.
     *
     * @example print gps.getSentenceCount()
     */
    public long getSentenceCount() {
        return sentences;
    }

    /**
     * Sentences left out because they were damaged.
     *
     * @example print gps.getDamagedCount()
     */
    public long getDamagedCount() {
        return reader.getDamaged();
    }

    /**
     * The fields of a GGA sentence. Token 0 is {@code "$GPGGA"}, 2 the latitude as ddmm.mmmm and 4 the longitude as dddmm.mmmm, both negative in
     * the south and west ({@code "-08051.8999"}), 6 the quality of the fix, 9 the altitude in metres.
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
        reader.feed(bytes);
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
                onGga(new GgaFix(sentence));
            } catch (IllegalArgumentException e) {
                Warnings.publish(this, "%s sent a GGA sentence that makes no sense: %s", getName(), sentence);
            }
        }
    }

    private void askFirmware() {
        asked = true;
        if (!PLAIN.equals(config.model)) {
            try {
                sendCommand(Pmtk.QUERY_RELEASE.body());
            } catch (IllegalStateException e) {
                log.info("{} can't be asked for its firmware: {}", getName(), e.getMessage());
            }
        }
    }

    /** {@code MTK3301_1.0} is an MT3301's, {@code AXN_1.30} an MT3329's. */
    private void onFirmware(String release) {
        firmware = release;
        if (release.contains("3301")) {
            config.model = "MT3301";
        } else if (release.startsWith("AXN")) {
            config.model = "MT3329";
        }
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

    private void onGga(GgaFix received) {
        lastFix = received;
        if (fix != received.hasFix()) {
            fix = received.hasFix();
            if (fix) {
                info("%s has a fix", getName());
            } else {
                Warnings.publish(this, "%s has lost its fix", getName());
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
            Warnings.publish(this, "no data from %s on port %s at %d baud for %s s: is it switched on, and is this its baud rate?", getName(),
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
