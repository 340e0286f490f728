package org.myrobotlab.service;

import java.io.IOException;
import java.util.Collections;
import java.util.List;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.LIDARConfig;
import org.myrobotlab.service.interfaces.SerialDataListener;
import org.myrobotlab.service.lidar.LmsScan;
import org.myrobotlab.service.lidar.LmsDevice;
import org.myrobotlab.service.link.FindsBaudRate;
import org.myrobotlab.service.link.PanelFiles;
import org.myrobotlab.service.link.SerialLink;

/**
 * Driver for a SICK LMS200 (and its sisters), real or simulated, on any port of MyRobotLab's Serial service.
 *
 * <pre>
 * lidar = Runtime.start("frontLidar", "LIDAR")
 * lidar.connect("/dev/SEAR_LIDAR_01")
 * lidar.addListener("publishLidarData", python.getName(), "onFrontLidarData")
 * lidar.setScanMode(100, 1)
 * lidar.singleScan()
 * </pre>
 *
 * <p>Every call returns at once; what was asked is sent one after the other, each when the former was answered, and repeated when the device
 * refuses it or stays silent. Errors are published as error statuses. Any thread.
 */
public class LIDAR extends Service<LIDARConfig> implements SerialDataListener, FindsBaudRate {
    private static final long serialVersionUID = 1L;
    private static final String PEER = "serial";

    static {
        PanelFiles.install(LIDAR.class);
    }

    private transient SerialLink link;
    private transient LmsDevice device;
    private boolean connected;
    private boolean streaming;
    private String unit = "mm";
    private double spread;
    private double resolution;
    private long scans;

    /** As MyRobotLab makes services. */
    public LIDAR(String name, String id) {
        super(name, id);
    }

    @Override
    public synchronized void startService() {
        super.startService();
        if (device == null) {
            Serial serial = (Serial) startPeer(PEER);
            device = new LmsDevice(new LidarEvents(this));
            link = new SerialLink(serial, this, device::tick, this::lost);
            device.attach(link);
        }
    }

    /**
     * Connects to the port the LIDAR is on, at the configured baud rate, 9600 unless set: the device's own after power-on. If it answers at another
     * rate, the port follows.
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
     * @param baud 9600, 19200, 38400 or 500000
     * @throws IOException if there is no such port, or it is in use
     * @example lidar.connect("/dev/SEAR_LIDAR_01", 38400)
     */
    public void connect(String port, int baud) throws IOException {
        if (link == null) {
            startService();
        }
        LmsDevice.checkedBaud(baud);
        disconnect();
        link.connect(port, baud);
        config.baud = baud;
        config.port = port;
        connected = true;
        device.learn();
        broadcastState();
    }

    /**
     * Connects again to the port last used, for example after a cable came loose.
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
        if (link != null) {
            link.disconnect();
            gone();
        }
    }

    private void gone() {
        device.clear();
        if (connected) {
            connected = false;
            streaming = false;
            broadcastState();
        }
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
     * The device's type.
     *
     * @param model LMS200, LMS211, LMS220, LMS221 or LMS291: they talk alike
     * @throws IllegalArgumentException that names those there are
     * @example lidar.setModel("LMS200")
     */
    public void setModel(String model) {
        config.model = LmsDevice.checkedModel(model);
        broadcastState();
    }

    /**
     * Tells the device to talk at another rate, and follows it there; not connected: the rate of the next {@link #connect}.
     *
     * @param baud 9600, 19200, 38400 or 500000
     * @throws IllegalArgumentException that names those there are
     * @example lidar.setBaud(38400)
     */
    public void setBaud(int baud) {
        LmsDevice.checkedBaud(baud);
        if (isConnected()) {
            device.setBaud(baud);
        } else {
            config.baud = baud;
        }
    }

    /**
     * Sets the width of the fan and the angle between its beams, degrees.
     *
     * @param spread 100 or 180
     * @param resolution 1, 0.5 or (with 100) 0.25
     * @throws IllegalArgumentException for other values
     * @throws IllegalStateException if it is not connected
     * @example lidar.setScanMode(180, 1)
     */
    public void setScanMode(int spread, double resolution) {
        ready().setVariant(spread, resolution);
    }

    /**
     * Values in centimetres, up to 81.83 m.
     *
     * @throws IllegalStateException if it is not connected
     * @example lidar.setToCM()
     */
    public void setToCM() {
        ready().setUnit(false);
    }

    /**
     * Values in millimetres, up to 8.183 m.
     *
     * @throws IllegalStateException if it is not connected
     * @example lidar.setToMM()
     */
    public void setToMM() {
        ready().setUnit(true);
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

    private LmsDevice ready() {
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
     * angles (degrees, 0 right, 90 ahead, 180 left).
     *
     * @example scan = lidar.getLastScan()
     */
    public LmsScan getLastScan() {
        return device == null ? null : device.getLastScan();
    }

    /**
     * A scan's values, right to left, in the device's unit, without flag bits: up to 8182 a distance, from 8183 a code, 8191 = nothing hit
     * (measuring modes 0 to 2).
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
    public LmsScan publishScan(LmsScan scan) {
        return scan;
    }

    void onScan(LmsScan scan) {
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

    void onUnit(String newUnit) {
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
