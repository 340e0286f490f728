// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.Arrays;
import org.SEAR.protocol.mrlcomm.MrlFunction;
import org.SEAR.protocol.mrlcomm.MrlMessage;

/**
 * Pins that MrlComm reads, each at its own rate. Their readings share messages: address and value, three bytes per pin,
 * at most 20 pins per message.
 */
final class MrlPinReports {
    private static final int MOST = 20;
    private static final int SECOND = 1000;
    private static final double MILLISECOND = 0.001;
    private static final double HALF = 0.5;

    private final Firmware.Host host;
    private final Pins pins;
    private final int[] order;
    private final boolean[] analog;
    private final int[] periods;
    private final long[] read;
    private int count;

    MrlPinReports(Firmware.Host host) {
        this.host = host;
        this.pins = host.pins();
        int size = pins.board().getPins();
        this.order = new int[size];
        this.analog = new boolean[size];
        this.periods = new int[size];
        this.read = new long[size];
    }

    void clear() {
        count = 0;
    }

    int size() {
        return count;
    }

    /**
     * Starts reading a pin; does nothing if it is read already.
     *
     * @param rate readings per second; 0 for one in each loop
     */
    void enable(int pin, boolean isAnalog, int rate) {
        if (indexOf(pin) >= 0) {
            return;
        }
        if (!isAnalog && pins.mode(pin) != Pins.Mode.PULLUP) {
            pins.setMode(pin, Pins.Mode.INPUT);
        }
        analog[pin] = isAnalog;
        periods[pin] = rate <= 0 ? 0 : SECOND / rate + 1;
        read[pin] = 0;
        order[count++] = pin;
    }

    void disable(int pin) {
        int index = indexOf(pin);
        if (index >= 0) {
            System.arraycopy(order, index + 1, order, index, count - index - 1);
            count--;
        }
    }

    private int indexOf(int pin) {
        for (int i = 0; i < count; i++) {
            if (order[i] == pin) {
                return i;
            }
        }
        return -1;
    }

    /** Sends the readings that are due. Skips the loop while the line is busy, during which a real program waits. */
    void loop(double time) {
        if (count == 0 || host.lineFreeAt() > time) {
            return;
        }
        long millis = (long) Math.floor(time / MILLISECOND + HALF);
        byte[] values = new byte[3 * MOST];
        int size = 0;
        for (int i = 0; i < count; i++) {
            int pin = order[i];
            if (periods[pin] == 0 || read[pin] == 0 || millis >= read[pin] + periods[pin]) {
                read[pin] = millis;
                int value = analog[pin] ? pins.readAnalog(pin) : pins.read(pin) ? 1 : 0;
                values[size++] = (byte) pin;
                values[size++] = (byte) (value >> Byte.SIZE);
                values[size++] = (byte) value;
                if (size == values.length) {
                    report(values, time);
                    size = 0;
                }
            }
        }
        if (size > 0) {
            report(Arrays.copyOf(values, size), time);
        }
    }

    private void report(byte[] values, double time) {
        host.send(MrlMessage.of(MrlFunction.PUBLISH_PIN_ARRAY).addList(values).end().toBytes(), time);
    }
}
