// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.IOException;
import java.util.Collections;
import java.util.List;
import org.myrobotlab.serial.PortArrivals;
import org.myrobotlab.service.config.LIDARConfig;
import org.myrobotlab.service.lidar.LidarChoice;
import org.myrobotlab.service.lidar.LidarDevice;
import org.myrobotlab.service.lidar.LidarModels;
import org.myrobotlab.service.lidar.RangeScan;
import org.myrobotlab.service.link.FindsBaudRate;
import org.myrobotlab.service.link.OwnConfigService;
import org.myrobotlab.service.link.PanelFiles;
import org.myrobotlab.service.link.Reconnects;
import org.myrobotlab.service.link.SerialLink;

/**
 * Drives a real or simulated SICK LMS2xx, Hokuyo URG-04LX or UTM-30LX, or Slamtec RPLIDAR A1 through MyRobotLab's
 * Serial service.
 *
 * <pre>
 * lidar = Runtime.start("frontLidar", "LIDAR")
 * lidar.setModel("LMS200")
 * lidar.connect("/dev/SEAR_LIDAR_01")
 * lidar.addListener("publishLidarData", python.getName(), "onFrontLidarData")
 * lidar.setScanMode(100, 1)
 * lidar.singleScan()
 * </pre>
 *
 * <p>Every call returns immediately. Requests wait in a queue until the previous one is answered, and are repeated
 * after a refusal or a timeout. Errors are published as error statuses. Any thread.
 */
public class LIDAR extends OwnConfigService<LIDARConfig> implements Reconnects, FindsBaudRate {
    private static final long serialVersionUID = 1L;
    private static final String PEER = "serial";
    private static final String MILLIMETRES = "mm";
    private static final String CENTIMETRES = "cm";

    static {
        PanelFiles.install();
    }

    private transient SerialLink link;
    private transient volatile LidarDevice device;
    private transient String driven;
    private volatile boolean connected;
    private volatile boolean streaming;
    /** Whether the unit was set since the connection opened. */
    private transient volatile boolean unitAsked;
    private volatile String unit = MILLIMETRES;
    private volatile double spread;
    private volatile double resolution;
    private volatile long scans;

    /** Called by MyRobotLab. */
    public LIDAR(String name, String id) {
        super(name, id);
    }

    @Override
    protected Class<LIDARConfig> configType() {
        return LIDARConfig.class;
    }

    @Override
    public synchronized void startService() {
        super.startService();
        if (link == null) {
            Serial serial = (Serial) startPeer(PEER);
            link = new SerialLink(serial, this, () -> device.tick(), this::lost);
            takeDriver();
            Reconnects.restore(this, config.port, link);
        }
    }

    /** Creates the driver of the configured model unless it is in use already. */
    private void takeDriver() {
        if (driven == null || !driven.equals(config.model)) {
            device = LidarModels.driver(config.model, new LidarEvents(this));
            device.attach(link);
            driven = config.model;
            spread = 0;
            resolution = 0;
            unit = MILLIMETRES;
        }
    }

    /**
     * Connects to the LIDAR's port at the configured baud rate. Default: the model's power-on rate, 9600 for an LMS200.
     * If the device answers at another rate, the port follows.
     *
     * @param port port, for example {@code "/dev/SEAR_LIDAR_01"} or {@code "COM3"}
     * @throws IOException port missing or in use
     * @example lidar.connect("/dev/SEAR_LIDAR_01")
     */
    public void connect(String port) throws IOException {
        connect(port, config.baud);
    }

    /**
     * Connects to the LIDAR's port, forgets all data of the previous connection and queries unit and modes. If it
     * answers at another rate, the port follows.
     *
     * @param port port name
     * @param baud a rate of {@link #setBaud}
     * @throws IOException port missing or in use
     * @example lidar.connect("/dev/SEAR_LIDAR_01", 38400)
     */
    public void connect(String port, int baud) throws IOException {
        if (link == null) {
            startService();
        }
        LidarModels.checkedBaud(config.model, baud);
        disconnect();
        driven = null;
        scans = 0;
        takeDriver();
        link.connect(port, baud);
        config.baud = baud;
        config.port = port;
        connected = true;
        unitAsked = false;
        device.learn();
        broadcastState();
    }

    /**
     * Reconnects to the last port. Returning simulated ports and restored configurations reconnect automatically.
     *
     * @throws IOException port missing or in use
     * @example lidar.reconnectSerial()
     */
    public void reconnectSerial() throws IOException {
        if (config.port == null) {
            throw new IOException(getName() + " was never connected: call connect(port) first");
        }
        connect(config.port, config.baud);
    }

    /**
     * Closes the port and drops unanswered requests.
     *
     * @example lidar.disconnect()
     */
    public void disconnect() {
        PortArrivals.forget(getName());
        if (link != null) {
            link.disconnect();
            gone();
        }
    }

    private void gone() {
        boolean was = connected;
        forget();
        if (was) {
            broadcastState();
        }
    }

    private void forget() {
        device.clear();
        connected = false;
        streaming = false;
    }

    /** Reports a port that its owner has closed. */
    private void lost() {
        String port = link == null ? null : link.closeIfLost(this::forget);
        if (port != null) {
            broadcastState();
            info("port %s was closed: %s reconnects when a simulation opens it, otherwise call reconnectSerial()",
                port, getName());
        }
    }

    /**
     * Sets the device's type before connecting. A model with another protocol also sets its power-on baud rate.
     *
     * @param model LMS200, LMS211, LMS220, LMS221 or LMS291 (one protocol), URG-04LX, UTM-30LX or RPLIDAR-A1
     * @throws IllegalArgumentException unknown model
     * @throws IllegalStateException connected device with another protocol
     * @example lidar.setModel("LMS200")
     */
    public synchronized void setModel(String model) {
        LidarModels.checked(model);
        if (isConnected() && !LidarModels.talkAlike(driven, model)) {
            throw new IllegalStateException(getName() + " is connected to a " + driven
                + ": disconnect() before setModel(\"" + model + "\")");
        }
        if (!LidarModels.talkAlike(config.model, model) || !LidarModels.hasBaud(model, config.baud)) {
            config.baud = LidarModels.firstBaud(model);
        }
        if (!LidarModels.talkAlike(config.model, model)) {
            config.unit = null;
        }
        config.model = model;
        if (link != null && !isConnected()) {
            takeDriver();
        }
        broadcastState();
    }

    /**
     * Returns the models with their baud rates and common scan modes, also published to the panel.
     *
     * @example print [model.name for model in lidar.getModels()]
     */
    public List<LidarChoice> getModels() {
        return LidarModels.choices();
    }

    /**
     * Changes the baud rate of the device and port, or of the next {@link #connect}.
     *
     * @param baud one of the model's rates; LMS200: 9600, 19200, 38400 or 500000; URG-04LX: 19200 to 750000
     * @throws IllegalArgumentException unsupported rate
     * @example lidar.setBaud(38400)
     */
    public void setBaud(int baud) {
        LidarModels.checkedBaud(config.model, baud);
        if (isConnected()) {
            device.setBaud(baud);
        } else {
            config.baud = baud;
        }
    }

    /**
     * Sets the scan's angular range and resolution, degrees. Some devices round them, see {@link #getSpread} and
     * {@link #getResolution}.
     *
     * @param spread LMS200: 100 or 180; URG-04LX: up to 240; UTM-30LX: up to 270; RPLIDAR-A1: up to 360
     * @param resolution LMS200: 1, 0.5 or (with 100) 0.25
     * @throws IllegalArgumentException other values
     * @throws IllegalStateException not connected
     * @example lidar.setScanMode(180, 1)
     */
    public void setScanMode(int spread, double resolution) {
        ready().setVariant(spread, resolution);
    }

    /**
     * Sets centimetres, up to 81.83 m; only for LMS models. The service remembers the unit and sets it after
     * connecting.
     *
     * @throws IllegalArgumentException model without centimetres
     * @throws IllegalStateException not connected
     * @example lidar.setToCM()
     */
    public void setToCM() {
        setUnit(false);
    }

    /**
     * Sets millimetres, for an LMS200 up to 8.183 m; remembered like {@link #setToCM}.
     *
     * @throws IllegalStateException not connected
     * @example lidar.setToMM()
     */
    public void setToMM() {
        setUnit(true);
    }

    private void setUnit(boolean millimetres) {
        unitAsked = true;
        ready().setUnit(millimetres);
        config.unit = millimetres ? MILLIMETRES : CENTIMETRES;
    }

    /**
     * Requests one scan, published by publishLidarData and publishScan.
     *
     * @throws IllegalStateException not connected
     * @example lidar.singleScan()
     */
    public void singleScan() {
        ready().singleScan();
    }

    /**
     * Starts continuous scans.
     *
     * @throws IllegalStateException not connected
     * @example lidar.startStreaming()
     */
    public void startStreaming() {
        ready().setStreaming(true);
    }

    /**
     * Ends {@link #startStreaming}.
     *
     * @throws IllegalStateException not connected
     * @example lidar.stopStreaming()
     */
    public void stopStreaming() {
        ready().setStreaming(false);
    }

    private LidarDevice ready() {
        if (!isConnected()) {
            lost();
            throw new IllegalStateException(getName() + " is not connected: call connect(port) first");
        }
        return device;
    }

    /**
     * Returns whether a port is open.
     *
     * @example print lidar.isConnected()
     */
    public boolean isConnected() {
        return connected && !link.isLost();
    }

    /**
     * Returns the sorted port names; also published to the panel.
     *
     * @example print lidar.getPortNames()
     */
    public List<String> getPortNames() {
        return link == null ? Collections.emptyList() : link.getPortNames();
    }

    /**
     * Returns the last scan; None before the first. Its arrays run right to left: raw (in its unit, "mm" or "cm"),
     * metres (None without a hit) and angles (degrees). Angle 0 is right, 90 ahead, 180 left; a full circle begins
     * behind, at -90.
     *
     * @example scan = lidar.getLastScan()
     */
    public RangeScan getLastScan() {
        return device == null ? null : device.getLastScan();
    }

    /**
     * Publishes a scan's values, right to left, in the device's unit, without flag bits. LMS200: distances to 8182,
     * codes from 8183, 8191 = no hit (measuring modes 0 to 2). Codes of others: URG-04LX 0 to 19, UTM-30LX 1 to 5,
     * RPLIDAR 0.
     *
     * @example lidar.addListener("publishLidarData", python.getName(), "onGuideScan")
     */
    public int[] publishLidarData(int[] values) {
        return values;
    }

    /**
     * Publishes the same scan with angles, metres and unit, as {@link #getLastScan} returns it.
     *
     * @example lidar.addListener("publishScan", python.getName(), "onGuideMetres")
     */
    public RangeScan publishScan(RangeScan scan) {
        return scan;
    }

    void onScan(RangeScan scan) {
        scans++;
        onUnit(scan.unit);
        invoke("publishLidarData", (Object) scan.raw);
        invoke("publishScan", scan);
    }

    void onStreaming(boolean on) {
        streaming = on;
        broadcastState();
    }

    void onScanMode(double newSpread, double newResolution) {
        spread = newSpread;
        resolution = newResolution;
        broadcastState();
    }

    /** The device has reported its unit. Sets the configured unit if it differs. */
    void onUnit(boolean millimetres) {
        String reported = millimetres ? MILLIMETRES : CENTIMETRES;
        onUnit(reported);
        if (config.unit != null && !config.unit.equals(reported) && !unitAsked) {
            setUnit(!millimetres);
        }
    }

    private void onUnit(String newUnit) {
        if (!newUnit.equals(unit)) {
            unit = newUnit;
            broadcastState();
        }
    }

    void onBaud(int baud) {
        config.baud = baud;
        broadcastState();
    }

    /**
     * Returns whether the device scans continuously.
     *
     * @example print lidar.isStreaming()
     */
    public boolean isStreaming() {
        return streaming;
    }

    /**
     * Returns the device's unit, {@code "mm"} or {@code "cm"}.
     *
     * @example print lidar.getUnit()
     */
    public String getUnit() {
        return unit;
    }

    /**
     * Returns the reported degrees from the first to the last beam; 0 until reported.
     *
     * @example print lidar.getSpread()
     */
    public double getSpread() {
        return spread;
    }

    /**
     * Returns the reported degrees between beams; 0 until reported.
     *
     * @example print lidar.getResolution()
     */
    public double getResolution() {
        return resolution;
    }

    /**
     * Counts scans of this connection.
     *
     * @example print lidar.getScanCount()
     */
    public long getScanCount() {
        return scans;
    }

    @Override
    public void onBytes(byte[] bytes) {
        if (device != null) {
            device.receive(bytes);
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
