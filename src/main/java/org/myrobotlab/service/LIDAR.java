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
 * Driver for a SICK LMS200 (and its sisters), a Hokuyo URG-04LX or UTM-30LX or a Slamtec RPLIDAR A1, real or simulated, on any port of MyRobotLab's
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
 * <p>Every call returns at once; what was asked is sent one after the other, each when the former was answered, and repeated when the device
 * refuses it or stays silent. Errors are published as error statuses. Any thread.
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
    private boolean connected;
    private boolean streaming;
    /** Whether the device was told the unit since it is connected. */
    private transient volatile boolean unitAsked;
    private String unit = MILLIMETRES;
    private double spread;
    private double resolution;
    private long scans;

    /** As MyRobotLab makes services. */
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

    /** Takes the driver of the configured model, unless it has it already. */
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
     * Connects to the port the LIDAR is on, at the configured baud rate, that of the model after power-on unless set: 9600 for an LMS200. If it
     * answers at another rate, the port follows.
     *
     * @param port the port's name, for example {@code "/dev/SEAR_LIDAR_01"} or {@code "COM3"}
     * @throws IOException if there is no such port, or it is in use
     * @example lidar.connect("/dev/SEAR_LIDAR_01")
     */
    public void connect(String port) throws IOException {
        connect(port, config.baud);
    }

    /**
     * Connects to the port the LIDAR is on, and asks the device for its unit and its modes. If it answers at another rate, the port follows.
     *
     * @param port the port's name
     * @param baud one that the model has: an LMS200 9600, 19200, 38400 or 500000
     * @throws IOException if there is no such port, or it is in use
     * @example lidar.connect("/dev/SEAR_LIDAR_01", 38400)
     */
    public void connect(String port, int baud) throws IOException {
        if (link == null) {
            startService();
        }
        LidarModels.checkedBaud(config.model, baud);
        disconnect();
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
     * Connects again to the port last used, for example after a cable came loose. A simulated port that comes back, and one of a restored
     * configuration, needs no such call.
     *
     * @throws IOException if there was none, or it is gone, or in use
     * @example lidar.reconnectSerial()
     */
    public void reconnectSerial() throws IOException {
        if (config.port == null) {
            throw new IOException(getName() + " was never connected: call connect(port) first");
        }
        connect(config.port, config.baud);
    }

    /**
     * Closes the port; what was not answered is forgotten.
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

    /** Looks whether the port was closed by somebody else, and says so. */
    private void lost() {
        String port = link == null ? null : link.closeIfLost(this::forget);
        if (port != null) {
            broadcastState();
            info("port %s was closed: %s connects again when a simulation has it, else by reconnectSerial()", port, getName());
        }
    }

    /**
     * The device's type, before connecting. With one that talks otherwise the baud rate becomes that which it has at power-on.
     *
     * @param model LMS200, LMS211, LMS220, LMS221 or LMS291, which talk alike, URG-04LX, UTM-30LX or RPLIDAR-A1
     * @throws IllegalArgumentException that names those there are
     * @throws IllegalStateException if a device that talks otherwise is connected
     * @example lidar.setModel("LMS200")
     */
    public synchronized void setModel(String model) {
        LidarModels.checked(model);
        if (isConnected() && !LidarModels.talkAlike(driven, model)) {
            throw new IllegalStateException(getName() + " is connected to a " + driven + ": disconnect() before setModel(\"" + model + "\")");
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
     * The models there are, with the baud rates and common scan modes of each; published to the panel.
     *
     * @example print [model.name for model in lidar.getModels()]
     */
    public List<LidarChoice> getModels() {
        return LidarModels.choices();
    }

    /**
     * Tells the device to talk at another rate, and follows it there; not connected: the rate of the next {@link #connect}.
     *
     * @param baud one that the model has: an LMS200 9600, 19200, 38400 or 500000, an URG-04LX 19200 to 750000
     * @throws IllegalArgumentException that names those there are
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
     * Sets the width of the fan and the angle between its beams, degrees. A device with steps of its own takes the nearest that it has, see
     * {@link #getSpread} and {@link #getResolution}.
     *
     * @param spread an LMS200 has 100 and 180, an URG-04LX up to 240, an UTM-30LX up to 270, an RPLIDAR-A1 up to 360
     * @param resolution an LMS200 has 1, 0.5 and (with 100) 0.25
     * @throws IllegalArgumentException for other values
     * @throws IllegalStateException if it is not connected
     * @example lidar.setScanMode(180, 1)
     */
    public void setScanMode(int spread, double resolution) {
        ready().setVariant(spread, resolution);
    }

    /**
     * Values in centimetres, up to 81.83 m. Only an LMS can. The service remembers it: it tells a device that it finds with another unit.
     *
     * @throws IllegalArgumentException if the model can't
     * @throws IllegalStateException if it is not connected
     * @example lidar.setToCM()
     */
    public void setToCM() {
        setUnit(false);
    }

    /**
     * Values in millimetres, of an LMS200 up to 8.183 m. Remembered as {@link #setToCM}.
     *
     * @throws IllegalStateException if it is not connected
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
     * Asks for one scan; it comes to whoever listens to publishLidarData or publishScan.
     *
     * @throws IllegalStateException if it is not connected
     * @example lidar.singleScan()
     */
    public void singleScan() {
        ready().singleScan();
    }

    /**
     * Has the device send scan after scan.
     *
     * @throws IllegalStateException if it is not connected
     * @example lidar.startStreaming()
     */
    public void startStreaming() {
        ready().setStreaming(true);
    }

    /**
     * Ends {@link #startStreaming}.
     *
     * @throws IllegalStateException if it is not connected
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
     * Whether a port is open.
     *
     * @example print lidar.isConnected()
     */
    public boolean isConnected() {
        return connected && !link.isLost();
    }

    /**
     * Names of the ports that there are, in order; published to the panel.
     *
     * @example print lidar.getPortNames()
     */
    public List<String> getPortNames() {
        return link == null ? Collections.emptyList() : link.getPortNames();
    }

    /**
     * The last scan; None before the first. Its arrays run right to left: raw (in its unit, "mm" or "cm"), metres (None where nothing was hit),
     * angles (degrees, 0 right, 90 ahead, 180 left; a whole circle begins behind, at -90).
     *
     * @example scan = lidar.getLastScan()
     */
    public RangeScan getLastScan() {
        return device == null ? null : device.getLastScan();
    }

    /**
     * A scan's values, right to left, in the device's unit, without flag bits. Of an LMS200: up to 8182 a distance, from 8183 a code, 8191 = nothing
     * hit (measuring modes 0 to 2). Of a Hokuyo the smallest values are codes: 0 to 19 of an URG-04LX, 1 to 5 of an UTM-30LX; of an RPLIDAR 0.
     *
     * @example lidar.addListener("publishLidarData", python.getName(), "onGuideScan")
     */
    public int[] publishLidarData(int[] values) {
        return values;
    }

    /**
     * The same scan with angles, metres and unit, as {@link #getLastScan} answers it.
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

    /** The device has told its unit: it gets the one that the configuration has. */
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
     * Whether scans come by themselves.
     *
     * @example print lidar.isStreaming()
     */
    public boolean isStreaming() {
        return streaming;
    }

    /**
     * {@code "mm"} or {@code "cm"}: what the device measures in.
     *
     * @example print lidar.getUnit()
     */
    public String getUnit() {
        return unit;
    }

    /**
     * Degrees from the first to the last beam, as the device told; 0 before it did.
     *
     * @example print lidar.getSpread()
     */
    public double getSpread() {
        return spread;
    }

    /**
     * Degrees between beams, as the device told; 0 before it did.
     *
     * @example print lidar.getResolution()
     */
    public double getResolution() {
        return resolution;
    }

    /**
     * Scans received since the service was made.
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
