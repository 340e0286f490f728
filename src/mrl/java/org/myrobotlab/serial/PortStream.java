// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.myrobotlab.logging.LoggerFactory;
import org.slf4j.Logger;

/** A port on two streams, for example of a TCP connection. Closing the port closes the streams. */
public class PortStream extends Port {
    public static final Logger log = LoggerFactory.getLogger(PortStream.class);

    private static final int MAX_AT_ONCE = 512;

    private transient InputStream in;
    private transient OutputStream out;
    private volatile boolean closing;

    public PortStream(String portName) throws IOException {
        super(portName);
    }

    public PortStream(String portName, InputStream in, OutputStream out) throws IOException {
        super(portName);
        this.in = in;
        this.out = out;
    }

    @Override
    public byte[] readBytes() {
        byte[] bytes = new byte[MAX_AT_ONCE];
        try {
            int count = in.read(bytes);
            return count < 0 ? null : Arrays.copyOf(bytes, count);
        } catch (IOException e) {
            if (!closing) {
                log.error("port {} can't be read any more: {}", portName, e.getMessage());
            }
            return null;
        }
    }

    @Override
    public void close() {
        closing = true;
        try {
            if (in != null) {
                in.close();
            }
            if (out != null) {
                out.close();
            }
        } catch (IOException e) {
            log.warn("port {}: {}", portName, e.getMessage());
        }
        super.close();
    }

    @Override
    public void write(int data) throws IOException {
        out.write(data);
        out.flush();
    }

    @Override
    public void write(byte[] data) throws IOException {
        out.write(data);
        out.flush();
    }

    public int available() throws IOException {
        return in.available();
    }

    public InputStream getInputStream() {
        return in;
    }

    public OutputStream getOutputStream() {
        return out;
    }

    public void setInputStream(InputStream newIn) {
        in = newIn;
    }

    public void setOutputStream(OutputStream newOut) {
        out = newOut;
    }

    @Override
    public boolean isHardware() {
        return false;
    }

    @Override
    public List<String> getPortNames() {
        return new ArrayList<>();
    }

    @Override
    public boolean setParams(int newRate, int newDataBits, int newStopBits, int newParity) {
        rate = newRate;
        dataBits = newDataBits;
        stopBits = newStopBits;
        parity = newParity;
        return true;
    }
}
