// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.imu;

import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.SerialDevice;

/**
 * A Honeywell HMC6352 compass behind a serial bridge. The bridge passes the chip's commands and replies. It answers
 * {@code 8E 2F} with an immediate heading, as the controller of the dissertation's Listing 9 does. Headings are 0 to
 * 3599 tenths of a degree in steps of five, high byte first. Sources: commands of the data sheet in RobTillaart's
 * library and Linux' driver; Listings 9 and 10.
 */
public final class Hmc6352 implements SerialDevice {
    /** Delay between command and answer, seconds. */
    private static final double CONVERSION = 0.006;
    private static final int SENSOR_REQUEST = 0x8E;
    private static final int COMPASS = 0x2F;
    private static final int FIRST_SENSOR = 0x2B;
    private static final int STEP = 5;
    private static final int TURN = 3600;
    private static final double STEPS_PER_DEGREE = 2;
    private static final int BYTE = 0xFF;
    private static final int BITS = 8;
    private static final int MODE_ADDRESS = 0x74;
    private static final int SAVED_MODE = 8;
    private static final int[] DELIVERED = {0x42, 0, 0, 0, 0, 1, 4, 6, 0x50};

    private final int baud;
    private final DeviceContext context;
    private final int[] permanent = new int[DELIVERED.length];
    private int mode;
    private boolean asleep;
    private boolean calibrating;
    private int heading;
    private int command;
    private int address = -1;

    /** @param baud baud rate of the bridge, bits per second */
    public Hmc6352(int baud, DeviceContext context) {
        this.baud = baud;
        this.context = context;
        reset();
    }

    @Override
    public void reset() {
        System.arraycopy(DELIVERED, 0, permanent, 0, DELIVERED.length);
        powerOn(0);
    }

    @Override
    public void powerOff() {
        command = 0;
    }

    @Override
    public void powerOn(double time) {
        mode = permanent[SAVED_MODE];
        asleep = false;
        calibrating = false;
        heading = 0;
        command = 0;
        address = -1;
    }

    @Override
    public int getBaud() {
        return baud;
    }

    @Override
    public void receive(int value, double time) {
        if (command == 0) {
            begin(value, time);
        } else if (command == SENSOR_REQUEST) {
            command = 0;
            if (value == COMPASS) {
                answerHeading(time);
            } else if (value < FIRST_SENSOR) {
                begin(value, time);
            }
        } else if (address < 0) {
            address = value;
            readAt(time);
        } else {
            write(value);
            command = 0;
        }
    }

    private void begin(int value, double time) {
        switch (value) {
            case 'A':
                if (!asleep && !calibrating) {
                    answerHeading(time + CONVERSION);
                }
                break;
            case 'S':
            case 'W':
                asleep = value == 'S';
                break;
            case 'C':
            case 'E':
                calibrating = value == 'C';
                break;
            case 'L':
                permanent[SAVED_MODE] = mode;
                break;
            case 'G':
            case 'g':
            case 'w':
            case 'r':
            case SENSOR_REQUEST:
                command = value;
                address = -1;
                break;
            default:
                break;
        }
    }

    /** Sends the heading; a dropped reading repeats the one before. */
    private void answerHeading(double time) {
        context.understood();
        double degrees = context.read(context.sensor()).numbers()[0];
        if (!Double.isNaN(degrees)) {
            heading = Math.floorMod(STEP * (int) Math.round(degrees * STEPS_PER_DEGREE), TURN);
        }
        context.send(new byte[] {(byte) (heading >> BITS), (byte) heading}, time);
    }

    private void readAt(double time) {
        if (command == 'g') {
            answer(address == MODE_ADDRESS ? mode : 0, time);
        } else if (command == 'r') {
            answer(address < permanent.length ? permanent[address] : 0, time);
        }
    }

    private void answer(int value, double time) {
        context.send(new byte[] {(byte) value}, time);
        command = 0;
    }

    private void write(int value) {
        if (command == 'G' && address == MODE_ADDRESS) {
            mode = value & BYTE;
        } else if (command == 'w' && address < permanent.length) {
            permanent[address] = value & BYTE;
        }
    }

    @Override
    public void receiveGarbage(double time) {
        command = 0;
    }

    @Override
    public void advance(double time) {
        // No unsolicited messages.
    }

    @Override
    public String title() {
        return "an HMC6352";
    }

    @Override
    public String status() {
        return "HMC6352: " + (asleep ? "asleep" : calibrating ? "calibrating" : "awake") + ", " + baud + " baud";
    }
}
