// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import java.io.ByteArrayOutputStream;
import org.SEAR.devices.RobotHardware;

/** Values of one robot's sensor packets, see {@link Packet}. */
final class SensorPackets {
    private static final int ROOM_TEMPERATURE = 25;
    private static final double ENCODER_COUNTS_PER_TURN = 508.8;
    private static final double STALLED = 0.99;
    /** Speed above which the front caster's sensor sees progress, m/s. */
    private static final double PROGRESS = 0.005;
    private static final double ROOMBA400_HALF_BASE = 129;
    private static final double MILLIMETRES = 1000;

    private final RoombaFirmware roomba;
    private final OiModel model;
    private final RobotHardware hardware;
    private final ProximitySensors proximity;
    private final SaturatingCounter distance = new SaturatingCounter();
    private final SaturatingCounter angle = new SaturatingCounter();

    SensorPackets(RoombaFirmware roomba, OiModel model, RobotHardware hardware, ProximitySensors proximity) {
        this.roomba = roomba;
        this.model = model;
        this.hardware = hardware;
        this.proximity = proximity;
    }

    /** Whether the model has a packet or group of that id. */
    boolean has(int id) {
        return Packet.of(id).length > 0 && id <= model.getLastPacket();
    }

    /** Appends the data of a packet or group. */
    void write(int id, ByteArrayOutputStream out, double time) {
        for (Packet packet : Packet.of(id)) {
            packet.write(value(packet, time), out);
        }
    }

    /** Clears distance and angle. */
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

    /** Mean of both wheels' encoders, millimetres, for wheels of nominal size. */
    private double distanceTotal() {
        return (hardware.getLeftWheelAngle() + hardware.getRightWheelAngle()) / 2 * hardware.getWheelRadius()
            * MILLIMETRES;
    }

    /**
     * Difference of both wheels' encoders, for wheels of nominal size at their nominal distance; 0 for a single wheel.
     */
    private double angleTotal() {
        double lead = (hardware.getRightWheelAngle() - hardware.getLeftWheelAngle()) * hardware.getWheelRadius();
        double turned = hardware.getTrack() > 0 ? lead / hardware.getTrack() : 0;
        return model.isAngleInMillimetres() ? turned * ROOMBA400_HALF_BASE : Math.toDegrees(turned);
    }

    /** Bit 0 right bumper, 1 left, 2 right wheel dropped, 3 left, 4 front. */
    int bumpsAndDrops() {
        return bit(hardware.isBumpedRight(), 0) | bit(hardware.isBumpedLeft(), 1)
            | bit(hardware.isRightWheelDropped(), 2)
            | bit(hardware.isLeftWheelDropped(), 3) | bit(model.hasCasterSwitch() && hardware.isCasterDropped(), 4);
    }

    private int value(Packet packet, double time) {
        if (packet.compareTo(Packet.DISTANCE) < 0) {
            return contact(packet);
        }
        if (packet.compareTo(Packet.CHARGING_SOURCES) <= 0) {
            return body(packet);
        }
        return packet.compareTo(Packet.REQUESTED_LEFT) <= 0 ? state(packet, time) : create2(packet);
    }

    private int contact(Packet packet) {
        switch (packet) {
            case BUMPS_AND_WHEEL_DROPS:
                return bumpsAndDrops();
            case WALL:
                return bit(proximity.isWall(), 0);
            case CLIFF_LEFT:
            case CLIFF_FRONT_LEFT:
            case CLIFF_FRONT_RIGHT:
            case CLIFF_RIGHT:
                return bit(proximity.isCliff(packet.ordinal() - Packet.CLIFF_LEFT.ordinal()), 0);
            case VIRTUAL_WALL:
                return bit(hardware.isInVirtualWall(), 0);
            case OVERCURRENTS:
                return bit(hardware.getLeftLoad() >= STALLED, 4) | bit(hardware.getRightLoad() >= STALLED, 3);
            case INFRARED:
                return model.getNoInfrared();
            case BUTTONS:
                return roomba.getButtons();
            default:
                return 0;
        }
    }

    private int body(Packet packet) {
        Battery battery = roomba.getBattery();
        switch (packet) {
            case DISTANCE:
                return distance.read(distanceTotal());
            case ANGLE:
                return angle.read(angleTotal());
            case VOLTAGE:
                return battery.getVoltage();
            case CURRENT:
                return battery.getCurrent();
            case TEMPERATURE:
                return ROOM_TEMPERATURE;
            case CHARGE:
                return battery.getCharge();
            case CAPACITY:
                return Battery.CAPACITY;
            case WALL_SIGNAL:
                return proximity.wallSignal();
            case CLIFF_LEFT_SIGNAL:
            case CLIFF_FRONT_LEFT_SIGNAL:
            case CLIFF_FRONT_RIGHT_SIGNAL:
            case CLIFF_RIGHT_SIGNAL:
                return proximity.cliffSignal(packet.ordinal() - Packet.CLIFF_LEFT_SIGNAL.ordinal());
            default:
                return 0;
        }
    }

    private int state(Packet packet, double time) {
        Drive drive = roomba.getDrive();
        switch (packet) {
            case MODE:
                return roomba.getMode().ordinal();
            case SONG_NUMBER:
                return roomba.getSongs().getNumber();
            case SONG_PLAYING:
                return bit(roomba.getSongs().isPlaying(time), 0);
            case STREAM_PACKETS:
                return roomba.getStreamLength();
            case REQUESTED_VELOCITY:
                return drive.getVelocity();
            case REQUESTED_RADIUS:
                return drive.getRadius();
            case REQUESTED_RIGHT:
                return drive.getRequestedRight();
            default:
                return drive.getRequestedLeft();
        }
    }

    private int create2(Packet packet) {
        switch (packet) {
            case LEFT_ENCODER:
                return encoder(hardware.getLeftWheelAngle());
            case RIGHT_ENCODER:
                return encoder(hardware.getRightWheelAngle());
            case LIGHT_BUMPER:
                return proximity.lightBumpers();
            case LIGHT_LEFT:
            case LIGHT_FRONT_LEFT:
            case LIGHT_CENTRE_LEFT:
            case LIGHT_CENTRE_RIGHT:
            case LIGHT_FRONT_RIGHT:
            case LIGHT_RIGHT:
                return proximity.lightSignal(packet.ordinal() - Packet.LIGHT_LEFT.ordinal());
            case LEFT_MOTOR_CURRENT:
                return (int) Math.round(hardware.getLeftLoad() * Battery.STALLED_WHEEL);
            case RIGHT_MOTOR_CURRENT:
                return (int) Math.round(hardware.getRightLoad() * Battery.STALLED_WHEEL);
            case STASIS:
                return bit(roomba.getDrive().isForward() && hardware.getSpeed() > PROGRESS, 0);
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
