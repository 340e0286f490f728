// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.ubx;

/**
 * Known messages of u-blox receivers by class and number. Class F0 contains NMEA sentences, whose rates are set in the
 * same way.
 */
public enum UbxMessage {
    NAV_POSECEF(0x01, 0x01),
    NAV_POSLLH(0x01, 0x02),
    NAV_STATUS(0x01, 0x03),
    NAV_DOP(0x01, 0x04),
    NAV_SOL(0x01, 0x06),
    NAV_PVT(0x01, 0x07),
    NAV_VELECEF(0x01, 0x11),
    NAV_VELNED(0x01, 0x12),
    NAV_TIMEGPS(0x01, 0x20),
    NAV_CLOCK(0x01, 0x22),
    NAV_SAT(0x01, 0x35),
    NAV_EOE(0x01, 0x61),
    ACK_NAK(0x05, 0x00),
    ACK_ACK(0x05, 0x01),
    CFG_PRT(0x06, 0x00),
    CFG_MSG(0x06, 0x01),
    CFG_RST(0x06, 0x04),
    CFG_RATE(0x06, 0x08),
    CFG_CFG(0x06, 0x09),
    CFG_SBAS(0x06, 0x16),
    CFG_NMEA(0x06, 0x17),
    CFG_NAV5(0x06, 0x24),
    CFG_GNSS(0x06, 0x3E),
    MON_VER(0x0A, 0x04),
    NMEA_GGA(0xF0, 0x00),
    NMEA_GLL(0xF0, 0x01),
    NMEA_GSA(0xF0, 0x02),
    NMEA_GSV(0xF0, 0x03),
    NMEA_RMC(0xF0, 0x04),
    NMEA_VTG(0xF0, 0x05),
    NMEA_ZDA(0xF0, 0x08);

    /** Class of navigation results. */
    public static final int NAV = 0x01;
    /** Class of settings. */
    public static final int CFG = 0x06;
    private static final int NMEA = 0xF0;

    private final int group;
    private final int id;

    UbxMessage(int group, int id) {
        this.group = group;
        this.id = id;
    }

    /** Finds a message by class and number; null if unknown. */
    public static UbxMessage of(int group, int id) {
        for (UbxMessage message : values()) {
            if (message.group == group && message.id == id) {
                return message;
            }
        }
        return null;
    }

    /** Class, 0 to 255. */
    public int getGroup() {
        return group;
    }

    /** Number within the class, 0 to 255. */
    public int getId() {
        return id;
    }

    /** Whether a receiver can send it periodically. */
    public boolean isPeriodic() {
        return group == NAV || group == NMEA;
    }
}
