package org.SEAR.devices.oi;

import java.io.ByteArrayOutputStream;
import org.SEAR.devices.RobotHardware;

/**
 * The sensor packets 7 to 58 and the groups of them, as bytes: words have their high byte first. Source: the packet tables of the specifications.
 */
final class Packets {
    static final int DISTANCE = 19;
    static final int ANGLE = 20;
    static final int FIRST = 7;
    private static final int LAST_SINGLE = 58;
    /** Group id, first and last packet. */
    private static final int[][] GROUPS = {{0, 7, 26}, {1, 7, 16}, {2, 17, 20}, {3, 21, 26}, {4, 27, 34}, {5, 35, 42}, {6, 7, 42},
        {100, 7, 58}, {101, 43, 58}, {106, 46, 51}, {107, 54, 58}};
    /** Packets of two bytes, by range. */
    private static final int[][] WORDS = {{19, 20}, {22, 23}, {25, 31}, {33, 33}, {39, 44}, {46, 51}, {54, 57}};
    private static final int TEMPERATURE = 25;
    private static final double ENCODER_COUNTS_PER_TURN = 508.8;
    private static final double STALLED = 0.99;
    private static final double ROOMBA400_HALF_BASE = 129;
    private static final double MILLIMETRES = 1000;

    private final Roomba roomba;
    private final OiModel model;
    private final RobotHardware hardware;
    private final Surroundings surroundings;
    private final Counter distance = new Counter();
    private final Counter angle = new Counter();

    Packets(Roomba roomba, OiModel model, RobotHardware hardware, Surroundings surroundings) {
        this.roomba = roomba;
        this.model = model;
        this.hardware = hardware;
        this.surroundings = surroundings;
    }

    /** Whether the model has a packet or group of that id. */
    boolean has(int id) {
        return size(id) > 0 && id <= model.getLastPacket();
    }

    /** Number of bytes of a packet or group; 0 for none such. */
    static int size(int id) {
        for (int[] group : GROUPS) {
            if (group[0] == id) {
                int sum = 0;
                for (int i = group[1]; i <= group[2]; i++) {
                    sum += size(i);
                }
                return sum;
            }
        }
        if (id < FIRST || id > LAST_SINGLE) {
            return 0;
        }
        for (int[] range : WORDS) {
            if (id >= range[0] && id <= range[1]) {
                return 2;
            }
        }
        return 1;
    }

    void write(int id, ByteArrayOutputStream out, double time) {
        for (int[] group : GROUPS) {
            if (group[0] == id) {
                for (int i = group[1]; i <= group[2]; i++) {
                    write(i, out, time);
                }
                return;
            }
        }
        int value = value(id, time);
        if (size(id) == 2) {
            out.write(value >> 8);
        }
        out.write(value);
    }

    /** Forgets distance and angle so far. */
    void clearCounters() {
        distance.clear(distanceTotal());
        angle.clear(angleTotal());
    }

    void clearDistance() {
        distance.clear(distanceTotal());
    }

    void clearAngle() {
        angle.clear(angleTotal());
    }

    /** Millimetres since the distance was last read or cleared. */
    double distanceSince() {
        return distance.peek(distanceTotal());
    }

    /** Degrees (Roomba 400: millimetres) since the angle was last read or cleared. */
    double angleSince() {
        return angle.peek(angleTotal());
    }

    private double distanceTotal() {
        return hardware.getPath() * MILLIMETRES;
    }

    private double angleTotal() {
        double turned = hardware.getTurned();
        return model.isAngleInMillimetres() ? turned * ROOMBA400_HALF_BASE : Math.toDegrees(turned);
    }

    /** Bit 0 right bumper, 1 left, 2 right wheel dropped, 3 left, 4 front. */
    int bumpsAndDrops() {
        return bit(hardware.isBumpedRight(), 0) | bit(hardware.isBumpedLeft(), 1) | bit(hardware.isRightWheelDropped(), 2)
            | bit(hardware.isLeftWheelDropped(), 3) | bit(model.hasCasterSwitch() && hardware.isCasterDropped(), 4);
    }

    private int value(int id, double time) {
        if (id <= 18) {
            return contact(id);
        }
        return id <= 34 ? body(id) : id <= 42 ? state(id, time) : create2(id);
    }

    private int contact(int id) {
        switch (id) {
            case 7:
                return bumpsAndDrops();
            case 8:
                return bit(surroundings.isWall(), 0);
            case 9:
            case 10:
            case 11:
            case 12:
                return bit(surroundings.isCliff(id - 9), 0);
            case 13:
                return bit(hardware.isInVirtualWall(), 0);
            case 14:
                return bit(hardware.getLeftLoad() >= STALLED, 4) | bit(hardware.getRightLoad() >= STALLED, 3);
            case 17:
                return model.getNoInfrared();
            case 18:
                return roomba.getButtons();
            default:
                return 0;
        }
    }

    private int body(int id) {
        Battery battery = roomba.getBattery();
        switch (id) {
            case DISTANCE:
                return distance.read(distanceTotal());
            case ANGLE:
                return angle.read(angleTotal());
            case 22:
                return battery.getVoltage();
            case 23:
                return battery.getCurrent();
            case 24:
                return TEMPERATURE;
            case 25:
                return battery.getCharge();
            case 26:
                return Battery.CAPACITY;
            case 27:
                return surroundings.wallSignal();
            case 28:
            case 29:
            case 30:
            case 31:
                return surroundings.cliffSignal(id - 28);
            default:
                return 0;
        }
    }

    private int state(int id, double time) {
        Drive drive = roomba.getDrive();
        switch (id) {
            case 35:
                return roomba.getMode().ordinal();
            case 36:
                return roomba.getSongs().getNumber();
            case 37:
                return bit(roomba.getSongs().isPlaying(time), 0);
            case 38:
                return roomba.getStreamLength();
            case 39:
                return drive.getVelocity();
            case 40:
                return drive.getRadius();
            case 41:
                return drive.getRequestedRight();
            default:
                return drive.getRequestedLeft();
        }
    }

    private int create2(int id) {
        switch (id) {
            case 43:
                return encoder(hardware.getLeftWheelAngle());
            case 44:
                return encoder(hardware.getRightWheelAngle());
            case 45:
                return surroundings.lightBumpers();
            case 46:
            case 47:
            case 48:
            case 49:
            case 50:
            case 51:
                return surroundings.lightSignal(id - 46);
            case 54:
                return (int) Math.round(hardware.getLeftLoad() * Battery.STALLED_WHEEL);
            case 55:
                return (int) Math.round(hardware.getRightLoad() * Battery.STALLED_WHEEL);
            case 58:
                return bit(roomba.getDrive().isForward(), 0);
            default:
                return 0;
        }
    }

    private static int encoder(double radians) {
        return (short) Math.floorMod((long) Math.floor(radians / (2 * Math.PI) * ENCODER_COUNTS_PER_TURN), 0x10000L);
    }

    private static int bit(boolean on, int number) {
        return on ? 1 << number : 0;
    }
}
