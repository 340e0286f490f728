// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;

/**
 * Settings of a u-blox receiver that have no effect on sentences or fixes. They are stored and reported, because
 * drivers set them at their start and some fail on a rejection. Simulation thread.
 */
final class StoredSettings {
    private static final int NMEA_SIZE = 20;
    /** Accepted lengths of CFG-NMEA, older ones included. */
    private static final List<Integer> NMEA_SIZES = Arrays.asList(4, 12, NMEA_SIZE);
    private static final int NAV5_SIZE = 36;
    private static final int MODEL = 1;
    private static final int FIX_MODE = 1 << 2;
    /** Parts of CFG-NAV5: bit of its mask, begin and end of its values. */
    private static final int[][] NAV5_PARTS = {{MODEL, 2, 3}, {1 << 1, 12, 13}, {FIX_MODE, 3, 12}, {1 << 3, 13, 14},
        {1 << 4, 14, 16},
        {1 << 4, 18, 20}, {1 << 5, 16, 18}, {1 << 5, 20, 22}, {1 << 6, 22, 23}, {1 << 6, 28, 30}, {1 << 7, 23, 24},
        {1 << 8, 24, 26},
        {1 << 10, 30, 31}};
    private static final List<Integer> MODELS = Arrays.asList(0, 2, 3, 4, 5, 6, 7, 8, 9);
    private static final int LAST_FIX_MODE = 3;
    private static final int SBAS_SIZE = 8;
    private static final int GNSS_HEAD = 4;
    private static final int GNSS_BLOCK = 8;
    /** Channels of GPS, SBAS, Galileo, BeiDou, IMES, QZSS and GLONASS: identifier, minimum, maximum and flags. */
    private static final byte[][] SYSTEMS = {{0, 8, 16, 0, 1, 0, 1, 1}, {1, 1, 3, 0, 1, 0, 1, 1},
        {2, 4, 8, 0, 0, 0, 1, 1}, {3, 8, 16, 0, 0, 0, 1, 1},
        {4, 0, 8, 0, 0, 0, 1, 3}, {5, 0, 3, 0, 1, 0, 1, 5}, {6, 8, 14, 0, 1, 0, 1, 1}};

    private final Map<UbxMessage, byte[]> payloads = new EnumMap<>(UbxMessage.class);

    /** Creates the factory settings. */
    StoredSettings() {
        payloads.put(UbxMessage.CFG_NMEA, UbxFrame.room(NMEA_SIZE).put(1, (byte) 0x40).put(3, (byte) 2)
            .put(15, (byte) 1).array());
        payloads.put(UbxMessage.CFG_NAV5, UbxFrame.room(NAV5_SIZE).putShort(0, (short) -1).put(3, (byte) 3)
            .putInt(8, 10000).put(12, (byte) 5)
            .putShort(14, (short) 250).putShort(16, (short) 250).putShort(18, (short) 100).putShort(20, (short) 350)
                .put(23, (byte) 60).array());
        payloads.put(UbxMessage.CFG_SBAS, UbxFrame.room(SBAS_SIZE).put((byte) 1).put((byte) 3).put((byte) 3)
            .put((byte) 0).putInt(0x66251).array());
        ByteBuffer systems = UbxFrame.room(GNSS_HEAD + SYSTEMS.length * GNSS_BLOCK)
            .put(new byte[] {0, 32, 32, (byte) SYSTEMS.length});
        for (byte[] system : SYSTEMS) {
            systems.put(system);
        }
        payloads.put(UbxMessage.CFG_GNSS, systems.array());
    }

    /** Copies all settings of another instance. */
    void copy(StoredSettings other) {
        other.payloads.forEach((message, payload) -> payloads.put(message, payload.clone()));
    }

    /** Returns the payload of a setting; null if it is not stored here. */
    byte[] get(UbxMessage message) {
        return payloads.get(message);
    }

    /**
     * Changes a setting, or the parts that the message selects.
     *
     * @return whether the setting is stored here and the values are legal
     */
    boolean set(UbxMessage message, byte[] values) {
        byte[] kept = payloads.get(message);
        switch (message) {
            case CFG_NMEA:
                return NMEA_SIZES.contains(values.length) && take(values, 0, kept, 0, values.length);
            case CFG_SBAS:
                return values.length == SBAS_SIZE && take(values, 0, kept, 0, SBAS_SIZE);
            case CFG_NAV5:
                return values.length == NAV5_SIZE && setNavigation(values, kept);
            case CFG_GNSS:
                return values.length >= GNSS_HEAD && values.length == GNSS_HEAD + values[3] * GNSS_BLOCK
                    && setSystems(values, kept);
            default:
                return false;
        }
    }

    private static boolean take(byte[] values, int from, byte[] kept, int to, int size) {
        System.arraycopy(values, from, kept, to, size);
        return true;
    }

    private static boolean setNavigation(byte[] values, byte[] kept) {
        int mask = values[0] & 0xFF | (values[1] & 0xFF) << 8;
        boolean legal = ((mask & MODEL) == 0 || MODELS.contains((int) values[2]))
            && ((mask & FIX_MODE) == 0 || values[3] >= 1 && values[3] <= LAST_FIX_MODE);
        for (int[] part : NAV5_PARTS) {
            if (legal && (mask & part[0]) != 0) {
                take(values, part[1], kept, part[1], part[2] - part[1]);
            }
        }
        return legal;
    }

    private static boolean setSystems(byte[] values, byte[] kept) {
        boolean legal = true;
        for (int at = GNSS_HEAD; at < values.length; at += GNSS_BLOCK) {
            legal &= values[at] >= 0 && values[at] < SYSTEMS.length;
        }
        for (int at = GNSS_HEAD; legal && at < values.length; at += GNSS_BLOCK) {
            take(values, at, kept, GNSS_HEAD + values[at] * GNSS_BLOCK, GNSS_BLOCK);
        }
        return legal;
    }
}
