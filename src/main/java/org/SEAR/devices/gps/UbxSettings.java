// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.nio.ByteBuffer;
import java.util.EnumMap;
import java.util.Map;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;

/** Settings of a u-blox receiver, stored as payloads of its messages. Simulation thread. */
final class UbxSettings {
    /** The only connected port. */
    static final int UART = 1;
    /** Number of ports with a message rate: DDC, UART 1 and 2, USB, SPI, one more. */
    static final int PORTS = 6;
    static final int PORT_SIZE = 20;
    static final int BAUD_AT = 8;
    static final int IN_AT = 12;
    static final int OUT_AT = 14;
    static final int MODE_AT = 4;
    /** 8 bits, no parity, one stop bit. */
    static final int MODE = 0x08D0;
    /** Bits of the protocol masks. */
    static final int UBX = 1;
    static final int NMEA = 2;
    static final int RTCM = 4;
    static final int RATE_SIZE = 6;

    /** Payloads of CFG-PRT. */
    final byte[][] ports = new byte[PORTS][];
    /** Output interval of a message in fixes, for each port. */
    final Map<UbxMessage, byte[]> rates = new EnumMap<>(UbxMessage.class);
    /** Payload of CFG-RATE. */
    final byte[] rate;
    final StoredSettings kept = new StoredSettings();

    /** Creates the factory settings. */
    UbxSettings(int baud, int period) {
        for (int i = 0; i < PORTS; i++) {
            ByteBuffer port = UbxFrame.room(PORT_SIZE);
            port.put(0, (byte) i).putInt(MODE_AT, i == UART ? MODE : 0).putInt(BAUD_AT, i == UART ? baud : 0);
            ports[i] = port.putShort(IN_AT, (short) (UBX | NMEA | RTCM)).putShort(OUT_AT, (short) (UBX | NMEA)).array();
        }
        for (UbxMessage message : UbxMessage.values()) {
            if (message.isPeriodic()) {
                rates.put(message, new byte[PORTS]);
            }
        }
        for (UbxMessage each : new UbxMessage[] {UbxMessage.NMEA_RMC, UbxMessage.NMEA_VTG, UbxMessage.NMEA_GGA,
            UbxMessage.NMEA_GSA, UbxMessage.NMEA_GSV, UbxMessage.NMEA_GLL}) {
            java.util.Arrays.fill(rates.get(each), 0, PORTS - 1, (byte) 1);
        }
        rate = UbxFrame.room(RATE_SIZE).putShort((short) period).putShort((short) 1).putShort((short) 1).array();
    }

    /** Copies the groups of settings that a mask of CFG-CFG selects. */
    void copy(UbxSettings other, int mask) {
        if ((mask & Group.PORTS.bit) != 0) {
            for (int i = 0; i < PORTS; i++) {
                ports[i] = other.ports[i].clone();
            }
        }
        if ((mask & Group.MESSAGES.bit) != 0) {
            other.rates.forEach((message, values) -> rates.put(message, values.clone()));
        }
        if ((mask & Group.NAVIGATION.bit) != 0) {
            System.arraycopy(other.rate, 0, rate, 0, RATE_SIZE);
            kept.copy(other.kept);
        }
    }

    /** Settings that are saved or cleared together. */
    private enum Group {
        PORTS(1), MESSAGES(2), NAVIGATION(8);

        private final int bit;

        Group(int bit) {
            this.bit = bit;
        }
    }

    boolean isDue(UbxMessage message, long number) {
        int every = rates.get(message)[UART] & 0xFF;
        return every > 0 && number % every == 0;
    }

    boolean takes(int protocol) {
        return (number(ports[UART], IN_AT) & protocol) != 0;
    }

    boolean sends(int protocol) {
        return (number(ports[UART], OUT_AT) & protocol) != 0;
    }

    int baud() {
        return ByteBuffer.wrap(ports[UART]).order(java.nio.ByteOrder.LITTLE_ENDIAN).getInt(BAUD_AT);
    }

    /** Fix interval, milliseconds. */
    int period() {
        return number(rate, 0) * number(rate, 2);
    }

    private static int number(byte[] bytes, int at) {
        return bytes[at] & 0xFF | (bytes[at + 1] & 0xFF) << 8;
    }
}
