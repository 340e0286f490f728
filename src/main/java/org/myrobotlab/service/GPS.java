// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.regex.Pattern;
import org.SEAR.protocol.Uart;
import org.SEAR.protocol.nmea.Nmea;
import org.myrobotlab.serial.PortArrivals;
import org.myrobotlab.service.config.GPSConfig;
import org.myrobotlab.service.gps.CircleFence;
import org.myrobotlab.service.gps.Fix;
import org.myrobotlab.service.gps.GeoFence;
import org.myrobotlab.service.gps.GeoPoint;
import org.myrobotlab.service.gps.PolygonFence;
import org.myrobotlab.service.gps.ReceiverModel;
import org.myrobotlab.service.gps.Reception;
import org.myrobotlab.service.gps.UbxText;
import org.myrobotlab.service.link.OwnConfigService;
import org.myrobotlab.service.link.PanelFiles;
import org.myrobotlab.service.link.Reconnects;
import org.myrobotlab.service.link.SerialLink;
import org.myrobotlab.service.link.ServiceWarnings;

/**
 * Reads a real or simulated GPS receiver (NMEA or u-blox UBX) through MyRobotLab's Serial service.
 *
 * <pre>
 * gps = Runtime.start("roofGps", "GPS")
 * gps.addListener("publishGGAData", python.getName(), "onRoofGpsData")
 * gps.connect("/dev/SEAR_GPS_01")
 * </pre>
 *
 * <p>Reads GGA, GNS, RMC and GLL of any talker (GP, GN, GL, GA, GB ...), ZDA and NAV-PVT, with or without altitude.
 * Drops sentences with a wrong checksum. Warns once when it loses the fix or the data. Any thread.
 */
public class GPS extends OwnConfigService<GPSConfig> implements Reconnects {
    private static final long serialVersionUID = 1L;
    private static final String PEER = "serial";
    /** Characters allowed in a sentence between {@code $} and {@code *}. */
    private static final Pattern COMMAND = Pattern.compile("[ -~&&[^$*]]+");
    /** Seconds without a good sentence after which data counts as lost; receivers send once per second. */
    private static final double SILENCE = 5;
    /** Pause between the baud rate command and the change, beyond the command's own transmission time, seconds. */
    private static final double BEFORE_BAUD_CHANGE = 0.1;

    static {
        PanelFiles.install();
    }

    private transient volatile Reception reception = new Reception(new GpsEvents(this));
    private transient SerialLink link;
    private transient double lastHeard;
    private transient double changeBaudAt = Double.POSITIVE_INFINITY;
    private transient int nextBaud;
    /** Model before the receiver reported another one; null if it did not. */
    private transient String chosenModel;
    private volatile String firmware;
    private volatile boolean connected;
    private volatile boolean silent;
    private volatile boolean fix;
    private volatile long sentences;
    /** Number of connections so far; panels clear their data when it changes. */
    private long connections;

    /** Called by MyRobotLab. */
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
     * Connects to the receiver's port at the configured baud rate. Default: 9600 for a NEO-M8N, 38400 for others.
     *
     * @param port port, for example {@code "/dev/SEAR_GPS_01"} or {@code "COM3"}
     * @throws IOException port missing or in use
     * @example gps.connect("/dev/SEAR_GPS_01")
     */
    public void connect(String port) throws IOException {
        connect(port, config.baud);
    }

    /**
     * Connects to the receiver's port and forgets all data of the previous connection. After the first sentence it
     * queries the firmware, except for model NMEA. MediaTek firmware also sets the model, for this connection.
     *
     * @param port port name
     * @param baud a rate of {@link #setBaud}
     * @throws IOException port missing or in use
     * @example gps.connect("/dev/SEAR_GPS_01", 38400)
     */
    public void connect(String port, int baud) throws IOException {
        if (link == null) {
            startService();
        }
        model().checkedBaud(baud);
        disconnect();
        forget();
        link.connect(port, baud);
        config.baud = baud;
        config.port = port;
        lastHeard = link.timeOutNow();
        connected = true;
        broadcastState();
    }

    /** Forgets everything about the receiver of the previous connection. */
    private synchronized void forget() {
        reception = new Reception(new GpsEvents(this));
        changeBaudAt = Double.POSITIVE_INFINITY;
        silent = false;
        fix = false;
        firmware = null;
        sentences = 0;
        connections++;
        config.model = chosenModel == null ? config.model : chosenModel;
        chosenModel = null;
    }

    /**
     * Reconnects to the last port. Returning simulated ports and restored configurations reconnect automatically.
     *
     * @throws IOException port missing or in use
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

    /** Reports a port that its owner has closed. */
    private void lost() {
        String port = link == null ? null : link.closeIfLost(() -> connected = false);
        if (port != null) {
            broadcastState();
            info("port %s was closed: %s reconnects when a simulation opens it, otherwise call reconnectSerial()",
                port, getName());
        }
    }

    /**
     * Changes the receiver's baud rate ({@code $PMTK251}; NEO-M8N: CFG-PRT) and then the port's. If unconnected or of
     * model NMEA, it sets only the port's rate.
     *
     * @param baud 4800, 9600, 19200, 38400, 57600 or 115200; NEO-M8N also 230400, 460800 and 921600, others also 14400
     * @throws IllegalArgumentException unsupported rate
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
     * Sets fixes per second ({@code $PMTK220}; NEO-M8N: CFG-RATE). The receiver drops sentences beyond the line's
     * capacity: at 9600 baud a NEO-M8N sends six kinds once per second.
     *
     * @param hertz 0.1 to 5; MT3329 and NEO-M8N to 10
     * @throws IllegalArgumentException unsupported rate
     * @throws IllegalStateException not connected
     * @example gps.setRate(5)
     */
    public void setRate(double hertz) {
        send(model().rateCommand(hertz));
    }

    private ReceiverModel model() {
        return ReceiverModel.of(config.model);
    }

    /**
     * Sets the receiver's type. While unconnected, an unchanged default baud rate becomes the new model's.
     *
     * @param model FV-M8 (or FV_M8), MT3301, MT3329 (PMTK commands), NEO-M8N (or u-blox; UBX) or NMEA (receives
     *     nothing)
     * @throws IllegalArgumentException unknown model
     * @example gps.setModel("FV-M8")
     */
    public void setModel(String model) {
        ReceiverModel old = model();
        ReceiverModel known = ReceiverModel.of(model);
        config.model = known.getLabel();
        chosenModel = null;
        if (!connected && config.baud == old.deliveredBaud()) {
            config.baud = known.deliveredBaud();
        }
        broadcastState();
    }

    /**
     * Sends a command to the receiver.
     *
     * @param body without {@code $} and checksum; {@code "PMTK220,200"} requests five fixes per second
     * @throws IllegalArgumentException characters not allowed in a sentence
     * @throws IllegalStateException not connected
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
     * @param hex class, number and payload without framing; {@code "06 01 01 07 01"} enables NAV-PVT
     * @throws IllegalArgumentException fewer than two hexadecimal bytes
     * @throws IllegalStateException not connected
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
     * Returns whether a port is open.
     *
     * @example print gps.isConnected()
     */
    public boolean isConnected() {
        return connected && !link.isLost();
    }

    /**
     * Returns the sorted port names; also published to the panel.
     *
     * @example print gps.getPortNames()
     */
    public List<String> getPortNames() {
        return link == null ? Collections.emptyList() : link.getPortNames();
    }

    /**
     * Returns whether the last fix had a position.
     *
     * @example print gps.hasFix()
     */
    public boolean hasFix() {
        return fix;
    }

    /**
     * Returns the reported firmware, for example {@code "MTK3301_1.0"} or {@code "EXT CORE 3.01 (107900)"}; None until
     * reported.
     *
     * @example print gps.getFirmware()
     */
    public String getFirmware() {
        return firmware;
    }

    /**
     * Returns the last fix of this connection; None before the first. Fields: latitude and longitude (decimal degrees,
     * + north and east), altitude (m), quality (0 = no fix), satellites, utc (hhmmss.sss) and tokens. A value that the
     * receiver does not report is None, for example the altitude in RMC or GLL and the position without a fix.
     *
     * @example fix = gps.getLastFix()
     */
    public Fix getLastFix() {
        return reception.getLastFix();
    }

    /**
     * Returns the UTC date and time of the last ZDA, NAV-PVT or RMC with a fix, for example
     * {@code "2026-11-28T19:01:09.000Z"}; None until the receiver reports a date. Needs no position.
     *
     * @example print gps.getTime()
     */
    public String getTime() {
        return reception.getTime();
    }

    /**
     * Counts valid sentences and UBX messages of this connection.
     *
     * @example print gps.getSentenceCount()
     */
    public long getSentenceCount() {
        return sentences;
    }

    /**
     * Counts dropped, damaged sentences and UBX messages of this connection.
     *
     * @example print gps.getDamagedCount()
     */
    public long getDamagedCount() {
        return reception.getDamaged();
    }

    /**
     * Returns a point for the calls below.
     *
     * @param latitude degrees, + north
     * @param longitude degrees, + east
     * @throws IllegalArgumentException latitude outside [-90, 90] or longitude outside [-180, 180]
     * @example home = gps.setPoint(33.61, -80.865); print home.getLat(), home.getLon()
     */
    public GeoPoint setPoint(double latitude, double longitude) {
        return new GeoPoint(latitude, longitude);
    }

    /**
     * Returns the distance between two places on the WGS84 ellipsoid, metres.
     *
     * @param latitude1 degrees, + north
     * @param longitude1 degrees, + east
     * @param latitude2 degrees, + north
     * @param longitude2 degrees, + east
     * @throws IllegalArgumentException value out of range, see {@link #setPoint}
     * @example print "%.2f m" % gps.calculateDistance(33.61, -80.865, 33.61, -80.864)
     */
    public double calculateDistance(double latitude1, double longitude1, double latitude2, double longitude2) {
        return calculateDistance(setPoint(latitude1, longitude1), setPoint(latitude2, longitude2));
    }

    /**
     * Returns the distance between two points, metres.
     *
     * @param from of {@link #setPoint}
     * @param to of {@link #setPoint}
     * @example print "%.2f m" % gps.calculateDistance(gps.setPoint(33.61, -80.865), gps.setPoint(33.62, -80.865))
     */
    public double calculateDistance(GeoPoint from, GeoPoint to) {
        given("the first point", from, "one of setPoint");
        given("the second point", to, "one of setPoint");
        return from.distanceTo(to);
    }

    /**
     * Returns a circular geofence for {@link #checkInside}.
     *
     * @param latitude degrees, + north
     * @param longitude degrees, + east
     * @param radius metres, &gt; 0
     * @throws IllegalArgumentException illegal value
     * @example fence = gps.setPointGeoFence(33.61, -80.865, 50)
     */
    public CircleFence setPointGeoFence(double latitude, double longitude, double radius) {
        return setPointGeoFence(setPoint(latitude, longitude), radius);
    }

    /**
     * Returns a circular geofence around a point.
     *
     * @param centre of {@link #setPoint}
     * @param radius metres, &gt; 0
     * @throws IllegalArgumentException illegal radius
     * @example fence = gps.setPointGeoFence(gps.setPoint(33.61, -80.865), 50)
     */
    public CircleFence setPointGeoFence(GeoPoint centre, double radius) {
        return new CircleFence(centre, radius);
    }

    /**
     * Returns a geofence with straight edges in latitude and longitude. The last corner is connected to the first.
     *
     * @param points corners, at least three points of {@link #setPoint}
     * @throws IllegalArgumentException too few corners, or values that are no points
     * @example field = gps.setPolygonGeoFence([gps.setPoint(33.6, -80.9), gps.setPoint(33.7, -80.9), gps.setPoint(33.6,
     * -80.8)])
     */
    public PolygonFence setPolygonGeoFence(List<?> points) {
        return new PolygonFence(points);
    }

    /**
     * Returns whether a place is inside a geofence.
     *
     * @param fence of {@link #setPointGeoFence} or {@link #setPolygonGeoFence}
     * @param latitude degrees, + north
     * @param longitude degrees, + east
     * @throws IllegalArgumentException value out of range, see {@link #setPoint}
     * @example print gps.checkInside(gps.setPointGeoFence(33.61, -80.865, 50), 33.6101, -80.865)
     */
    public boolean checkInside(GeoFence fence, double latitude, double longitude) {
        return checkInside(fence, setPoint(latitude, longitude));
    }

    /**
     * Returns whether a point is inside a geofence.
     *
     * @param fence of {@link #setPointGeoFence} or {@link #setPolygonGeoFence}
     * @param point of {@link #setPoint}
     * @example print gps.checkInside(gps.setPointGeoFence(33.61, -80.865, 50), gps.setPoint(33.6101, -80.865))
     */
    public boolean checkInside(GeoFence fence, GeoPoint point) {
        given("the geofence", fence, "one of setPointGeoFence or setPolygonGeoFence");
        given("the point", point, "one of setPoint");
        return fence.contains(point);
    }

    private static void given(String what, Object value, String legal) {
        if (value == null) {
            throw new IllegalArgumentException(what + " is None, legal: " + legal);
        }
    }

    /**
     * Returns the decimal degrees of a coordinate in {@link #publishGGAData}. A minus at its beginning is kept.
     *
     * @param nmea ddmm.mmmm or dddmm.mmmm
     * @throws IllegalArgumentException if it is no coordinate
     * @example print gps.convertNMEAToDegrees("-08051.9000")
     */
    public double convertNMEAToDegrees(String nmea) {
        given("the coordinate", nmea, "text as ddmm.mmmm");
        return nmea.startsWith("-") ? -Nmea.degrees(nmea.substring(1)) : Nmea.degrees(nmea);
    }

    /**
     * Publishes a GGA sentence's fields. 0: {@code "$GPGGA"}; 2: latitude, ddmm.mmmm; 4: longitude, dddmm.mmmm; 6: fix
     * quality; 9: altitude, metres. South and west are negative ({@code "-08051.8999"}). Fields that the receiver does
     * not report are empty. NAV-PVT and, from receivers without GGA, GNS, RMC and GLL take the same form; field 0
     * names the sentence. Of several sentences for one moment, one is published, GGA first.
     *
     * @example gps.addListener("publishGGAData", python.getName(), "onGuideGga")
     */
    public String[] publishGGAData(String[] tokens) {
        return tokens;
    }

    /**
     * Publishes the data of {@link #publishGGAData} under the name of the dissertation's Listing 8.
     *
     * @example gps.addListener("publishGGADData", python.getName(), "onGuideGgad")
     */
    public String[] publishGGADData(String[] tokens) {
        return tokens;
    }

    /**
     * Publishes [latitude, longitude, altitude] of each fix with a position: decimal degrees, + north and east, and
     * metres. The altitude is None if the receiver does not report it.
     *
     * @example gps.addListener("publishGPS", python.getName(), "onGuidePosition")
     */
    public Double[] publishGPS(Double[] position) {
        return position;
    }

    /**
     * Publishes each valid sentence from {@code $} to checksum.
     *
     * @example gps.addListener("publishSentence", python.getName(), "onGuideSentence")
     */
    public String publishSentence(String sentence) {
        return sentence;
    }

    @Override
    public void onBytes(byte[] bytes) {
        reception.feed(bytes);
    }

    /** Queries the firmware of a receiver that takes commands. */
    void askFirmware() {
        if (connected && model().takesCommands()) {
            try {
                send(model().firmwareQuestion());
            } catch (IllegalStateException e) {
                log.info("firmware query of {} failed: {}", getName(), e.getMessage());
            }
        }
    }

    /**
     * Takes the firmware that the receiver reports.
     *
     * @param named its model; null if unknown
     */
    void onFirmware(String release, ReceiverModel named) {
        firmware = release;
        if (named != null) {
            chosenModel = chosenModel == null ? config.model : chosenModel;
            config.model = named.getLabel();
        }
        broadcastState();
    }

    /** Sets whether there is a fix; returns whether this is a change. */
    boolean changeFix(boolean has) {
        boolean changed = fix != has;
        fix = has;
        return changed;
    }

    /** Notes that a valid sentence or message has arrived. */
    void heard() {
        sentences = reception.getCount();
        lastHeard = link == null ? 0 : link.timeOutNow();
        if (silent) {
            silent = false;
            info("%s sends again", getName());
            broadcastState();
        }
    }

    private synchronized void tick() {
        if (connected && link.timeOutNow() >= changeBaudAt) {
            changeBaudAt = Double.POSITIVE_INFINITY;
            link.setBaud(nextBaud);
        }
        if (connected && !silent && link.timeOutNow() - lastHeard > SILENCE) {
            silent = true;
            ServiceWarnings.publish(this, "no data from %s on port %s at %d baud for %s s: is it switched on, and is "
                + "this its baud rate?", getName(), link.getPortName(), link.getBaud(), SILENCE);
            broadcastState();
        }
    }

    @Override
    public void onConnect(String portName) {
        log.info("{} connected to {}", getName(), portName);
    }

    /** This service or the port's owner is closing the port. It may still be open: {@link SerialLink} checks again. */
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
