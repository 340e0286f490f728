// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;

/**
 * Sensor packets of the Open Interface: number, bytes on the line (words high byte first), sign and meaning. Sources:
 * the packet tables of the SCI specification 2005, Create OI 2006 and Create 2 OI 2016.
 */
public enum Packet {
    BUMPS_AND_WHEEL_DROPS(7, 1, false, "bit 0 right bumper, 1 left, 2 right wheel dropped, 3 left, 4 front"),
    WALL(8, 1, false, "1 = a wall on the right"),
    CLIFF_LEFT(9, 1, false, "1 = no ground"),
    CLIFF_FRONT_LEFT(10, 1, false, "1 = no ground"),
    CLIFF_FRONT_RIGHT(11, 1, false, "1 = no ground"),
    CLIFF_RIGHT(12, 1, false, "1 = no ground"),
    VIRTUAL_WALL(13, 1, false, "1 = in a virtual wall's beam"),
    OVERCURRENTS(14, 1, false, "bit 3 right wheel, 4 left wheel"),
    DIRT_LEFT(15, 1, false, "0 to 255"),
    DIRT_RIGHT(16, 1, false, "0 to 255; unused on a Create"),
    INFRARED(17, 1, false, "byte received, 255 (Create 2: 0) for none"),
    BUTTONS(18, 1, false, "one bit each"),
    DISTANCE(19, 2, true, "mm since the last request"),
    ANGLE(20, 2, true, "degrees (Roomba 400: the right wheel's lead in mm) since the last request, counter-clockwise"),
    CHARGING_STATE(21, 1, false, "0 = not charging"),
    VOLTAGE(22, 2, false, "mV"),
    CURRENT(23, 2, true, "mA, negative out of the battery"),
    TEMPERATURE(24, 1, true, "degrees Celsius"),
    CHARGE(25, 2, false, "mAh"),
    CAPACITY(26, 2, false, "mAh"),
    WALL_SIGNAL(27, 2, false, "0 to 4095, Create 2 0 to 1023"),
    CLIFF_LEFT_SIGNAL(28, 2, false, "0 to 4095"),
    CLIFF_FRONT_LEFT_SIGNAL(29, 2, false, "0 to 4095"),
    CLIFF_FRONT_RIGHT_SIGNAL(30, 2, false, "0 to 4095"),
    CLIFF_RIGHT_SIGNAL(31, 2, false, "0 to 4095"),
    DIGITAL_INPUTS(32, 1, false, "cargo bay of a Create, one bit each"),
    ANALOG_INPUT(33, 2, false, "cargo bay of a Create, 0 to 1023 = 0 to 5 V"),
    CHARGING_SOURCES(34, 1, false, "bit 0 internal charger, 1 home base"),
    MODE(35, 1, false, "0 off, 1 passive, 2 safe, 3 full"),
    SONG_NUMBER(36, 1, false, "the song last played"),
    SONG_PLAYING(37, 1, false, "1 = playing"),
    STREAM_PACKETS(38, 1, false, "number of packets in the stream"),
    REQUESTED_VELOCITY(39, 2, true, "mm/s"),
    REQUESTED_RADIUS(40, 2, true, "mm"),
    REQUESTED_RIGHT(41, 2, true, "mm/s"),
    REQUESTED_LEFT(42, 2, true, "mm/s"),
    LEFT_ENCODER(43, 2, true, "508.8 counts per turn, rolls over"),
    RIGHT_ENCODER(44, 2, true, "508.8 counts per turn, rolls over"),
    LIGHT_BUMPER(45, 1, false, "bit 0 left, front left, centre left, centre right, front right, 5 right"),
    LIGHT_LEFT(46, 2, false, "0 to 4095"),
    LIGHT_FRONT_LEFT(47, 2, false, "0 to 4095"),
    LIGHT_CENTRE_LEFT(48, 2, false, "0 to 4095"),
    LIGHT_CENTRE_RIGHT(49, 2, false, "0 to 4095"),
    LIGHT_FRONT_RIGHT(50, 2, false, "0 to 4095"),
    LIGHT_RIGHT(51, 2, false, "0 to 4095"),
    INFRARED_LEFT(52, 1, false, "byte received, 0 for none"),
    INFRARED_RIGHT(53, 1, false, "byte received, 0 for none"),
    LEFT_MOTOR_CURRENT(54, 2, true, "mA"),
    RIGHT_MOTOR_CURRENT(55, 2, true, "mA"),
    MAIN_BRUSH_CURRENT(56, 2, true, "mA"),
    SIDE_BRUSH_CURRENT(57, 2, true, "mA"),
    STASIS(58, 1, false, "1 = moving forward");

    private static final int BYTE_BITS = 8;
    /** Group number, first and last packet. */
    private static final int[][] GROUPS = {{0, 7, 26}, {1, 7, 16}, {2, 17, 20}, {3, 21, 26}, {4, 27, 34},
        {5, 35, 42}, {6, 7, 42},
        {100, 7, 58}, {101, 43, 58}, {106, 46, 51}, {107, 54, 58}};
    private static final Packet[] NONE = {};
    private static final Packet[][] BY_NUMBER = byNumber();

    private final int number;
    private final int size;
    private final boolean signed;
    private final String meaning;

    Packet(int number, int size, boolean signed, String meaning) {
        this.number = number;
        this.size = size;
        this.signed = signed;
        this.meaning = meaning;
    }

    private static Packet[][] byNumber() {
        Packet[][] packets = new Packet[1 << BYTE_BITS][];
        Arrays.fill(packets, NONE);
        for (Packet packet : values()) {
            packets[packet.number] = new Packet[] {packet};
        }
        for (int[] group : GROUPS) {
            packets[group[0]] = Arrays.copyOfRange(values(), group[1] - values()[0].number,
                group[2] - values()[0].number + 1);
        }
        return packets;
    }

    /**
     * Returns the packet of a number, or the packets of a group in sending order; empty for other numbers.
     *
     * @param number 0 to 255
     */
    static Packet[] of(int number) {
        return BY_NUMBER[number];
    }

    /**
     * Number of data bytes of a packet or group; 0 for other numbers.
     *
     * @param number 0 to 255
     */
    public static int size(int number) {
        int sum = 0;
        for (Packet packet : BY_NUMBER[number]) {
            sum += packet.size;
        }
        return sum;
    }

    /** Packet number, 7 to 58. */
    public int getNumber() {
        return number;
    }

    /** Bytes on the line: 1 or 2. */
    public int getSize() {
        return size;
    }

    /** Whether the value is in two's complement. */
    public boolean isSigned() {
        return signed;
    }

    /** Meaning of the value, with its unit. */
    public String getMeaning() {
        return meaning;
    }

    /** Smallest value that fits. */
    public int getLeast() {
        return signed ? -(1 << size * BYTE_BITS - 1) : 0;
    }

    /** Largest value that fits. */
    public int getGreatest() {
        return signed ? (1 << size * BYTE_BITS - 1) - 1 : (1 << size * BYTE_BITS) - 1;
    }

    /** Appends a value in its form on the line, clamped to its range. */
    void write(int value, ByteArrayOutputStream out) {
        int held = Math.max(getLeast(), Math.min(getGreatest(), value));
        if (size == 2) {
            out.write(held >> BYTE_BITS);
        }
        out.write(held);
    }
}
