// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.embedded.serial.ByteRecord;
import org.myrobotlab.embedded.serial.ReadingService;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.serial.Port;
import org.myrobotlab.serial.PortJSSC;
import org.myrobotlab.serial.PortQueue;
import org.myrobotlab.serial.PortStream;
import org.myrobotlab.serial.SerialControl;
import org.myrobotlab.service.config.SerialConfig;
import org.myrobotlab.service.interfaces.PortConnector;
import org.myrobotlab.service.interfaces.PortPublisher;
import org.myrobotlab.service.interfaces.RecordControl;
import org.myrobotlab.service.interfaces.SerialDataListener;
import org.myrobotlab.service.interfaces.SerialDevice;
import org.slf4j.Logger;

/**
 * Opens a serial port, real or virtual, by its name. Received bytes go immediately to the byte listeners, on the port's
 * reader thread, and are published one by one (publishRX, 0 to 255) and in chunks (publishBytes). Any thread.
 */
public class Serial extends ReadingService implements SerialControl, SerialDataListener, RecordControl, SerialDevice,
    PortPublisher, PortConnector {
    public static final Integer BAUD_2400 = 2400;
    public static final Integer BAUD_4800 = 4800;
    public static final Integer BAUD_9600 = 9600;
    public static final Integer BAUD_19200 = 19200;
    public static final Integer BAUD_38400 = 38400;
    public static final Integer BAUD_57600 = 57600;
    public static final Integer BAUD_115200 = 115200;
    public static final Logger log = LoggerFactory.getLogger(Serial.class);

    private static final long serialVersionUID = 1L;
    private static final int BYTE = 0xFF;
    private static final int DATA_BITS = 8;
    private static final String TCP = "tcp://";
    /** All ports, real and virtual, opened or created in this process. Guarded by the class. */
    static transient HashMap<String, Port> ports = new HashMap<>();
    /** Names of all ports found or opened so far. */
    static HashSet<String> portNames = new HashSet<>();

    public String lastPortName;
    int BUFFER_SIZE = 1 << 20;
    int rate = BAUD_115200;
    int dataBits = DATA_BITS;
    int stopBits = 1;
    int parity;
    int rxCount;
    int txCount;
    volatile String portName;
    transient volatile Port port;
    final transient Map<String, Port> connectedPorts = new ConcurrentHashMap<>();
    transient Map<String, SerialDataListener> listeners = new ConcurrentHashMap<>();
    /** Names of the services that get the bytes by messages. */
    private final transient Set<String> byteListeners = ConcurrentHashMap.newKeySet();
    private final transient ByteRecord recordRx = new ByteRecord(this::error);
    private final transient ByteRecord recordTx = new ByteRecord(this::error);

    public Serial(String name, String id) {
        super(name, id);
        listeners.put(getName(), this);
    }

    /**
     * Includes the last opened port, for the record only: as in the real MyRobotLab, a restored service opens no port.
     */
    @Override
    public SerialConfig getConfig() {
        config.port = lastPortName;
        return config;
    }

    // ---- opening and closing
    // ------------------------------------------------------------------------------------------

    /** Opens a port with the current parameters. If another port is open, only logs that: disconnect first. */
    @Override
    public void connect(String name) throws IOException {
        open(name);
    }

    @Override
    public void connect(String name, int baud) throws Exception {
        connect(name, baud, DATA_BITS, 1, 0);
    }

    /** @param newParity 0 none, 1 odd, 2 even */
    @Override
    public void connect(String name, int baud, int newDataBits, int newStopBits, int newParity) throws IOException {
        open(name, baud, newDataBits, newStopBits, newParity);
    }

    /** Opens the last port again. */
    public void connect() throws IOException {
        connect(lastPortName);
    }

    @Override
    public void open(String name) throws IOException {
        open(name, rate, dataBits, stopBits, parity);
    }

    @Override
    public void open(String name, int baud, int newDataBits, int newStopBits, int newParity) throws IOException {
        if (name == null) {
            failCall("no port given; the ports are %s", new TreeSet<>(listPorts()));
            return;
        }
        if (portName != null && !portName.equals(name)) {
            info("already connected to %s - disconnect first to connect to %s", portName, name);
            return;
        }
        rate = baud;
        dataBits = newDataBits;
        stopBits = newStopBits;
        parity = newParity;
        Port found = known(name);
        if (found == null) {
            found = name.toLowerCase(Locale.ROOT).startsWith(TCP) ? createTCPPort(name, this)
                : createHardwarePort(name, baud, newDataBits, newStopBits, newParity);
        }
        if (found != null) {
            connectPort(found, null);
            setParams(baud, newDataBits, newStopBits, newParity);
        }
    }

    /**
     * Uses an existing port.
     *
     * @param listener also gets the bytes; may be null
     */
    public Port connectPort(Port newPort, SerialDataListener listener) throws IOException {
        if (listener != null) {
            listeners.put(listener.getName(), listener);
        }
        if (!newPort.isOpen()) {
            newPort.open();
        }
        newPort.listen(listeners);
        synchronized (Serial.class) {
            ports.put(newPort.getName(), newPort);
            portNames.add(newPort.getName());
        }
        port = newPort;
        portName = newPort.getName();
        lastPortName = portName;
        connectedPorts.put(portName, newPort);
        invoke("publishConnect", portName);
        for (SerialDataListener one : listeners.values()) {
            one.onConnect(portName);
        }
        broadcastState();
        return newPort;
    }

    /**
     * Closes the port. Calls the listeners first, on the caller's thread, while the port is still open, as the real
     * MyRobotLab does.
     */
    @Override
    public void disconnect() {
        String name = portName;
        if (name == null) {
            info("already disconnected");
            return;
        }
        invoke("publishDisconnect", name);
        for (SerialDataListener one : listeners.values()) {
            one.onDisconnect(name);
        }
        close();
        connectedPorts.clear();
        portName = null;
        port = null;
        broadcastState();
    }

    @Override
    public void close() {
        connectedPorts.values().forEach(Port::close);
    }

    @Override
    public boolean isConnected() {
        return portName != null;
    }

    @Override
    public void releaseService() {
        if (isConnected()) {
            disconnect();
        }
        stopRecording();
        super.releaseService();
    }

    /** @return whether the port accepts them */
    public boolean setParams(int baud, int newDataBits, int newStopBits, int newParity) throws IOException {
        Port open = port;
        if (open == null) {
            failCall("the port is not open: connect first");
            return false;
        }
        try {
            if (!open.setParams(baud, newDataBits, newStopBits, newParity)) {
                return false;
            }
        } catch (IOException | RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new IOException("port " + portName + " can't be set: " + e.getMessage(), e);
        }
        rate = baud;
        dataBits = newDataBits;
        stopBits = newStopBits;
        parity = newParity;
        return true;
    }

    // ---- ports
    // --------------------------------------------------------------------------------------------------------

    private static Port known(String name) {
        synchronized (Serial.class) {
            return ports.get(name);
        }
    }

    /**
     * Creates an unopened port of this computer, whether it exists or not; null without the library jssc, with an error
     * status.
     */
    public Port createHardwarePort(String name, int baud, int newDataBits, int newStopBits, int newParity) {
        try {
            Port made = new PortJSSC(name, baud, newDataBits, newStopBits, newParity);
            synchronized (Serial.class) {
                ports.put(name, made);
            }
            return made;
        } catch (IOException | LinkageError e) {
            log.debug("{}", name, e);
            error(e.getMessage());
            return null;
        }
    }

    /** Opens a TCP connection to {@code tcp://host:port}. */
    public Port createTCPPort(String url, SerialDataListener listener) throws IOException {
        URI uri = URI.create(url);
        Socket socket = new Socket(uri.getHost(), uri.getPort());
        return new PortStream(url, socket.getInputStream(), socket.getOutputStream());
    }

    public boolean connectTcp(String url) throws IOException {
        connectPort(createTCPPort(url, this), this);
        return true;
    }

    /** Creates a virtual port with nothing at its other end. */
    public PortQueue createVirtualPort(String name) {
        PortQueue made = new PortQueue(name);
        synchronized (Serial.class) {
            ports.put(name, made);
        }
        return made;
    }

    public static Serial connectVirtualUart(String myPort) throws IOException {
        return connectVirtualUart(null, myPort, myPort + ".UART");
    }

    public static Serial connectVirtualUart(String myPort, String uartPort) throws IOException {
        return connectVirtualUart(null, myPort, uartPort);
    }

    /**
     * Creates two virtual ports joined by a null-modem cable.
     *
     * @return the service at the end {@code uartPort}
     */
    public static Serial connectVirtualUart(Serial uart, String myPort, String uartPort) throws IOException {
        BlockingQueue<Integer> left = new LinkedBlockingQueue<>();
        BlockingQueue<Integer> right = new LinkedBlockingQueue<>();
        synchronized (Serial.class) {
            ports.put(myPort, new PortQueue(myPort, left, right));
        }
        Serial end = uart != null ? uart : (Serial) Runtime.start(myPort.replace('/', '_') + ".UART", "Serial");
        end.connectPort(new PortQueue(uartPort, right, left), end);
        return end;
    }

    @Override
    public List<String> getPortNames() {
        List<String> names = listPorts();
        invoke("publishPortNames", names);
        return names;
    }

    /** Returns the names of all ports, including former ones. */
    public static List<String> listPorts() {
        List<String> real = new PortJSSC().getPortNames();
        synchronized (Serial.class) {
            portNames.addAll(ports.keySet());
            portNames.addAll(real);
            return new ArrayList<>(new TreeSet<>(portNames));
        }
    }

    public Port getPort() {
        return port;
    }

    @Override
    public String getPortName() {
        return portName;
    }

    public String getLastPortName() {
        return lastPortName;
    }

    @Override
    public int getRate() {
        return rate;
    }

    @Override
    public int getDataBits() {
        return dataBits;
    }

    @Override
    public int getStopBits() {
        return stopBits;
    }

    @Override
    public int parity() {
        return parity;
    }

    public void setDTR(boolean on) {
        port.setDTR(on);
    }

    // ---- listeners
    // ----------------------------------------------------------------------------------------------------

    /** Sends all bytes to a service, from the next connect on. */
    public void addByteListener(SerialDataListener listener) {
        addByteListener(listener.getName());
    }

    /**
     * Sends all bytes to a service, from the next connect on: to a {@link SerialDataListener} by onBytes, to any other
     * service one by one by onByte and in chunks by onBytes. A script needs only one of the two functions.
     */
    public void addByteListener(String name) {
        ServiceInterface service = Runtime.getService(name);
        if (service == null) {
            failCall("%s can't get bytes: there is no such service", name);
        } else if (service instanceof SerialDataListener) {
            listeners.put(service.getName(), (SerialDataListener) service);
        } else {
            addListener("publishRX", name, "onByte");
            addListener("publishBytes", name, "onBytes");
            addPortListener(name);
            byteListeners.add(CodecUtils.getShortName(name));
        }
    }

    public void removeByteListener(SerialDataListener listener) {
        removeByteListener(listener.getName());
    }

    public void removeByteListener(String name) {
        listeners.remove(CodecUtils.getShortName(name));
        byteListeners.remove(CodecUtils.getShortName(name));
        removeListener("publishRX", name, "onByte");
        removeListener("publishBytes", name, "onBytes");
        removeListener("publishConnect", name, "onConnect");
        removeListener("publishDisconnect", name, "onDisconnect");
    }

    public void addPortListener(String name) {
        addListener("publishConnect", name, "onConnect");
        addListener("publishDisconnect", name, "onDisconnect");
    }

    /** Returns whether {@link #addByteListener} has added the service, by messages. */
    boolean isByteListener(String name) {
        return byteListeners.contains(name);
    }

    public Map<String, SerialDataListener> getListeners() {
        return listeners;
    }

    @Override
    public void onConnect(String name) {
        log.info("{} connected to {}", getName(), name);
    }

    @Override
    public void onDisconnect(String name) {
        log.info("{} disconnected from {}", getName(), name);
    }

    @Override
    public void onBytes(byte[] bytes) {
        for (byte one : bytes) {
            int value = one & BYTE;
            ++rxCount;
            if (blockingRX.size() < BUFFER_SIZE) {
                blockingRX.add(value);
            }
            invoke("publishRX", value);
        }
        recordRx.write(bytes);
        invoke("publishBytes", (Object) bytes);
    }

    // ---- published methods ------------------------------------------------------------------------------------------

    @Override
    public String publishConnect(String name) {
        return name;
    }

    @Override
    public String publishDisconnect(String name) {
        return name;
    }

    public List<String> publishPortNames(ArrayList<String> names) {
        return names;
    }

    /** Publishes each received byte, 0 to 255. */
    public int publishRX(Integer data) {
        return data;
    }

    /** Publishes each received chunk. */
    public byte[] publishBytes(byte[] bytes) {
        return bytes;
    }

    /** Publishes each sent byte. */
    public Integer publishTX(Integer data) {
        return data;
    }

    // ---- writing
    // ------------------------------------------------------------------------------------------------------

    /** Sends the low 8 bits. */
    @Override
    public synchronized void write(int data) throws Exception {
        write(new byte[] {(byte) data});
    }

    @Override
    public void write(byte[] data) throws Exception {
        if (connectedPorts.isEmpty()) {
            failCall("can not write to a closed port: connect first");
            return;
        }
        for (Port one : connectedPorts.values()) {
            one.write(data);
        }
        txCount += data.length;
        recordTx.write(data);
        for (byte one : data) {
            invoke("publishTX", one & BYTE);
        }
    }

    @Override
    public void write(String data) throws Exception {
        write(data.getBytes(StandardCharsets.UTF_8));
    }

    public void writeString(String data) throws Exception {
        write(data);
    }

    public void writeInt(int data) throws Exception {
        write(data);
    }

    @Override
    public void flush() {
        log.debug("{}: every write goes out at once", getName());
    }

    public int getRXCount() {
        return rxCount;
    }

    public void setBufferSize(int size) {
        BUFFER_SIZE = size;
    }

    // ---- recording
    // ----------------------------------------------------------------------------------------------------

    @Override
    public synchronized void record() throws FileNotFoundException {
        stopRecording();
        recordRx.open(getName() + ".rx.bin");
        recordTx.open(getName() + ".tx.bin");
    }

    @Override
    public synchronized void stopRecording() {
        recordRx.close();
        recordTx.close();
    }

    @Override
    public boolean isRecording() {
        return recordRx.isOpen();
    }

    @Override
    public String toString() {
        return getName() + "->" + portName;
    }
}
