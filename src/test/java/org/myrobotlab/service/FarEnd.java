// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.serial.VirtualSerialPort;

/** Replacement for a device at the far end of a cable. */
public final class FarEnd implements AutoCloseable {
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(60);

    private final VirtualSerialPort device;
    private final VirtualSerialPort user;
    private final Function<String, String> answers;
    private final List<String> heard = new ArrayList<>();

    /** @param answers maps hex received to hex sent; null for no answer */
    public FarEnd(String userPort, Function<String, String> answers) throws IOException {
        this.answers = answers;
        device = new VirtualSerialPort(userPort + "_device");
        user = new VirtualSerialPort(userPort);
        VirtualSerialPort.makeNullModem(device, user);
        device.setPaced(false);
        SerialDeviceFactory.add(device);
        SerialDeviceFactory.add(user);
        device.open();
        device.listen(new BytesListener(this::onBytes));
    }

    private void onBytes(byte[] bytes) {
        String text = hex(bytes);
        synchronized (heard) {
            heard.add(text);
            heard.notifyAll();
        }
        String answer = answers.apply(text);
        if (answer != null) {
            send(bytes(answer));
        }
    }

    public void send(byte[] bytes) {
        try {
            device.write(bytes);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Waits for this number of pieces and returns all received so far. */
    public List<String> await(int count) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE;
        synchronized (heard) {
            while (heard.size() < count && System.nanoTime() < end) {
                heard.wait(50);
            }
            return new ArrayList<>(heard);
        }
    }

    public static byte[] bytes(String hex) {
        String[] parts = hex.trim().split("\\s+");
        byte[] bytes = new byte[parts.length];
        for (int i = 0; i < parts.length; i++) {
            bytes[i] = (byte) Integer.parseInt(parts[i], 16);
        }
        return bytes;
    }

    public static String hex(byte[] bytes) {
        StringBuilder text = new StringBuilder();
        for (byte b : bytes) {
            text.append(text.length() == 0 ? "" : " ").append(String.format("%02X", b));
        }
        return text.toString();
    }

    @Override
    public void close() {
        SerialDeviceFactory.remove(device);
        SerialDeviceFactory.remove(user);
    }
}
