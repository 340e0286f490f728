// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.myrobotlab.logging.LoggerFactory;
import org.slf4j.Logger;

/** A virtual port: reads what its peer writes into the queue. */
public class PortQueue extends Port {
    public static final Logger log = LoggerFactory.getLogger(PortQueue.class);

    private static final int MAX_AT_ONCE = 512;
    private static final int BYTE = 0xFF;

    private final transient BlockingQueue<Integer> in;
    private final transient BlockingQueue<Integer> out;

    public PortQueue(String portName) {
        this(portName, new LinkedBlockingQueue<>(), new LinkedBlockingQueue<>());
    }

    public PortQueue(String portName, BlockingQueue<Integer> in, BlockingQueue<Integer> out) {
        super(portName);
        this.in = in;
        this.out = out;
    }

    @Override
    public byte[] readBytes() {
        List<Integer> taken = new ArrayList<>();
        try {
            taken.add(in.take());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return null;
        }
        in.drainTo(taken, MAX_AT_ONCE - 1);
        byte[] bytes = new byte[taken.size()];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = taken.get(i).byteValue();
        }
        return bytes;
    }

    @Override
    public void write(int data) throws IOException {
        out.add(data & BYTE);
    }

    @Override
    public void write(byte[] data) throws IOException {
        for (byte one : data) {
            write(one);
        }
    }

    public int available() throws IOException {
        return in.size();
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
