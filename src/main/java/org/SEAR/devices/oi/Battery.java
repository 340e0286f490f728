// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

/** A rechargeable battery. The drawn current drains it, and its voltage falls with its charge. */
final class Battery {
    /** Capacity, mAh, as in the documents' examples. */
    static final int CAPACITY = 2702;
    /** Current of the idle robot, mA. */
    static final int IDLE = 200;
    /** Current of the sleeping robot, mA. */
    static final int ASLEEP = 5;
    /** Current of a stalled wheel motor, mA. */
    static final int STALLED_WHEEL = 1000;
    private static final double EMPTY_VOLTAGE = 12920;
    private static final double VOLTAGE_SPAN = 2000;
    private static final double SECONDS_PER_HOUR = 3600;

    private double charge = CAPACITY;
    private double current;

    /** Draws a current for some time. */
    void drain(double milliamperes, double seconds) {
        current = milliamperes;
        charge = Math.max(0, charge - milliamperes * seconds / SECONDS_PER_HOUR);
    }

    /** Charge, mAh (packet 25). */
    int getCharge() {
        return (int) Math.round(charge);
    }

    /** Voltage, mV (packet 22). */
    int getVoltage() {
        return (int) Math.round(EMPTY_VOLTAGE + VOLTAGE_SPAN * charge / CAPACITY);
    }

    /** Current, mA, negative: out of the battery (packet 23). */
    int getCurrent() {
        return (int) -Math.round(current);
    }
}
