// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.myrobotlab.framework.QueueStats;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.interfaces.SerialDataListener;
import org.slf4j.Logger;

/** A serial port. While it has listeners, its reader thread passes them the received bytes. */
public abstract class Port implements Runnable, SerialControl {
    public static final Logger log = LoggerFactory.getLogger(Port.class);

    private static final int DEFAULT_RATE = 115200;
    private static final int DEFAULT_DATA_BITS = 8;
    private static final int JOIN_MS = 1000;

    public String portName;
    public boolean debug;
    public boolean debugTX;
    public boolean debugRX;
    int rate = DEFAULT_RATE;
    int dataBits = DEFAULT_DATA_BITS;
    int stopBits = 1;
    int parity;
    int txErrors;
    int rxErrors;
    volatile boolean listening;
    QueueStats stats = new QueueStats();
    transient volatile Thread readingThread;
    transient HashMap<String, SerialDataListener> listeners = new HashMap<>();
    private volatile boolean opened;

    public Port(String portName) {
        this.portName = portName;
        stats.name = portName;
    }

    public Port(String portName, int rate, int dataBits, int stopBits, int parity) throws IOException {
        this(portName);
        this.rate = rate;
        this.dataBits = dataBits;
        this.stopBits = stopBits;
        this.parity = parity;
    }

    public void open() throws IOException {
        opened = true;
    }

    /** Closes the port, ends its reader thread and removes its listeners. */
    public void close() {
        Thread reader;
        synchronized (this) {
            opened = false;
            listening = false;
            reader = readingThread;
            readingThread = null;
            listeners.clear();
        }
        if (reader != null) {
            reader.interrupt();
            if (reader != Thread.currentThread()) {
                await(reader);
            }
        }
    }

    private static void await(Thread reader) {
        try {
            reader.join(JOIN_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Adds listeners, by name, for received bytes. */
    public void listen(Map<String, SerialDataListener> added) {
        synchronized (this) {
            listeners.putAll(added);
            if (readingThread == null) {
                listening = true;
                Thread reader = new Thread(this, portName + ".portListener");
                reader.setDaemon(true);
                readingThread = reader;
                reader.start();
            }
        }
    }

    /** Adds a listener for received bytes. */
    public void listen(SerialDataListener listener) {
        listen(Map.of(listener.getName(), listener));
    }

    /** Runs the reader thread. */
    @Override
    public void run() {
        Thread own = Thread.currentThread();
        try {
            while (listening && readingThread == own) {
                byte[] bytes = readBytes();
                if (bytes == null) {
                    break;
                }
                hand(bytes);
            }
        } catch (InterruptedException e) {
            log.debug("reader of port {} was interrupted", portName);
        } catch (Exception e) {
            if (listening && readingThread == own) {
                log.error("port {} can't be read any more: {}", portName, e.getMessage(), e);
            }
        }
    }

    /** Passes bytes to all listeners. */
    void hand(byte[] bytes) {
        for (SerialDataListener listener : getListeners()) {
            try {
                listener.onBytes(bytes);
            } catch (RuntimeException e) {
                ++rxErrors;
                log.error("{} failed on bytes from port {}", listener.getName(), portName, e);
            }
        }
        count(bytes.length);
    }

    synchronized List<SerialDataListener> getListeners() {
        return new ArrayList<>(listeners.values());
    }

    private void count(int bytes) {
        int before = stats.total / stats.interval;
        stats.total += bytes;
        if (stats.total / stats.interval != before) {
            stats.ts = System.currentTimeMillis();
            stats.delta = Math.max(1, stats.ts - stats.lastTS);
            stats.lineSpeed = (long) Byte.SIZE * stats.interval / stats.delta;
            stats.lastTS = stats.ts;
        }
    }

    /** Waits for bytes; returns null at the end of the stream. */
    public abstract byte[] readBytes() throws Exception;

    /** Sends the low 8 bits. */
    public abstract void write(int data) throws Exception;

    public abstract void write(byte[] data) throws Exception;

    /** Returns whether this is a real port. */
    public abstract boolean isHardware();

    /** @return whether the port accepts them */
    public boolean setParams(int newRate, int newDataBits, int newStopBits, int newParity) throws Exception {
        rate = newRate;
        dataBits = newDataBits;
        stopBits = newStopBits;
        parity = newParity;
        return true;
    }

    public void setDTR(boolean on) {
        log.debug("port {} has no DTR to set {}", portName, on);
    }

    public String getName() {
        return portName;
    }

    public boolean isOpen() {
        return opened;
    }

    public boolean isListening() {
        return listening;
    }

    public int getBaudRate() {
        return rate;
    }

    public int getDataBits() {
        return dataBits;
    }

    public int getStopBits() {
        return stopBits;
    }

    public int getParity() {
        return parity;
    }

    public boolean isCTS() {
        return false;
    }

    public boolean isDSR() {
        return false;
    }
}
