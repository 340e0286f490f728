// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.io.IOException;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import jssc.SerialPort;
import jssc.SerialPortEvent;
import jssc.SerialPortEventListener;
import jssc.SerialPortException;
import jssc.SerialPortList;
import org.myrobotlab.logging.LoggerFactory;
import org.slf4j.Logger;

/** A real port or pseudo-terminal, through the library jssc. Bytes arrive on jssc's own thread. */
public class PortJSSC extends Port implements SerialControl, SerialPortEventListener, Serializable {
    public static final Logger log = LoggerFactory.getLogger(PortJSSC.class);

    private static final long serialVersionUID = 1L;

    transient SerialPort port;

    public PortJSSC() {
        super(null);
    }

    public PortJSSC(String portName, int rate, int dataBits, int stopBits, int parity) throws IOException {
        super(portName, rate, dataBits, stopBits, parity);
        port = new SerialPort(portName);
    }

    /** @throws IOException if the port can't be opened */
    @Override
    public void open() throws IOException {
        try {
            port.openPort();
            super.open();
            if (!port.setParams(rate, dataBits, stopBits, parity)) {
                log.warn("port {} does not accept {} baud, {} data bits, {} stop bits, parity {}", portName, rate,
                    dataBits, stopBits, parity);
            }
        } catch (SerialPortException e) {
            throw new IOException("port " + portName + " can't be opened: " + e.getExceptionType(), e);
        } catch (LinkageError e) {
            throw new IOException("port " + portName + " can't be opened, the library jssc does "
                + "not work here: " + e, e);
        }
    }

    @Override
    public void close() {
        super.close();
        try {
            if (port.isOpened()) {
                port.closePort();
            }
        } catch (SerialPortException e) {
            log.warn("port {} did not close cleanly: {}", portName, e.getExceptionType());
        }
    }

    /** Returns immediately: jssc calls {@link #serialEvent} on its own thread. */
    @Override
    public void run() {
        try {
            port.addEventListener(this, SerialPort.MASK_RXCHAR);
        } catch (SerialPortException e) {
            log.error("port {} can't be listened to: {}", portName, e.getExceptionType());
        }
    }

    @Override
    public void serialEvent(SerialPortEvent event) {
        byte[] bytes = readBytes();
        if (bytes != null && listening) {
            hand(bytes);
        }
    }

    /** Returns the received bytes; null if there are none. */
    @Override
    public byte[] readBytes() {
        try {
            return port.readBytes();
        } catch (SerialPortException e) {
            if (listening) {
                log.error("port {} can't be read: {}", portName, e.getExceptionType());
            }
            return null;
        }
    }

    @Override
    public void write(int data) throws Exception {
        port.writeByte((byte) data);
    }

    @Override
    public void write(byte[] data) throws Exception {
        port.writeBytes(data);
    }

    @Override
    public boolean setParams(int newRate, int newDataBits, int newStopBits, int newParity) throws SerialPortException {
        boolean taken = port.setParams(newRate, newDataBits, newStopBits, newParity);
        if (taken) {
            rate = newRate;
            dataBits = newDataBits;
            stopBits = newStopBits;
            parity = newParity;
        }
        return taken;
    }

    @Override
    public void setDTR(boolean on) {
        try {
            port.setDTR(on);
        } catch (SerialPortException e) {
            log.warn("port {}: DTR can't be set: {}", portName, e.getExceptionType());
        }
    }

    public void setRTS(boolean on) {
        try {
            port.setRTS(on);
        } catch (SerialPortException e) {
            log.warn("port {}: RTS can't be set: {}", portName, e.getExceptionType());
        }
    }

    @Override
    public boolean isCTS() {
        try {
            return port.isCTS();
        } catch (SerialPortException e) {
            return false;
        }
    }

    @Override
    public boolean isDSR() {
        try {
            return port.isDSR();
        } catch (SerialPortException e) {
            return false;
        }
    }

    @Override
    public boolean isOpen() {
        return port != null && port.isOpened();
    }

    @Override
    public boolean isHardware() {
        return true;
    }

    /** Returns the names of this computer's real ports. */
    @Override
    public List<String> getPortNames() {
        return new ArrayList<>(Arrays.asList(SerialPortList.getPortNames()));
    }
}
