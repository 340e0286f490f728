package org.SEAR.devices.oi;

/** A rechargeable battery: it drains by what is drawn, its voltage falls as it drains. */
final class Battery {
    /** mAh; the capacity in the documents' examples. */
    static final int CAPACITY = 2702;
    /** Drawn while the robot stands and listens, mA. */
    static final int IDLE = 200;
    /** Drawn while it sleeps, mA. */
    static final int ASLEEP = 5;
    /** Drawn by a stalled wheel motor, mA. */
    static final int STALLED_WHEEL = 1000;
    private static final double EMPTY_VOLTAGE = 12920;
    private static final double VOLTAGE_SPAN = 2000;
    private static final double SECONDS_PER_HOUR = 3600;

    private double charge = CAPACITY;
    private double current;

    /** Draws so many mA for so many seconds. */
    void drain(double milliamperes, double seconds) {
        current = milliamperes;
        charge = Math.max(0, charge - milliamperes * seconds / SECONDS_PER_HOUR);
    }

    /** Packet 25, mAh. */
    int getCharge() {
        return (int) Math.round(charge);
    }

    /** Packet 22, mV. */
    int getVoltage() {
        return (int) Math.round(EMPTY_VOLTAGE + VOLTAGE_SPAN * charge / CAPACITY);
    }

    /** Packet 23, mA, negative: out of the battery. */
    int getCurrent() {
        return (int) -Math.round(current);
    }
}
