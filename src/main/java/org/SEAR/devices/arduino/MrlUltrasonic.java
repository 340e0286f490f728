// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import org.SEAR.protocol.mrlcomm.MrlFunction;
import org.SEAR.protocol.mrlcomm.MrlMessage;

/**
 * An ultrasonic sensor of MrlComm. It pings continuously and reports whole centimetres when they change; 0 without an
 * echo within 500 cm.
 */
final class MrlUltrasonic implements MrlDevice {
    /** Microseconds of echo per centimetre, as in its library. */
    private static final int MICROS_A_CENTIMETRE = 57;
    private static final int MAX_CENTIMETRES = 500;
    private static final double MICROSECOND = 1e-6;
    private static final double LONGEST = (MAX_CENTIMETRES + 1) * MICROS_A_CENTIMETRE * MICROSECOND;

    private final int id;
    private final Firmware.Host host;
    private final int trigger;
    private final int listened;
    private boolean ranging;
    private int last;
    private double next;

    MrlUltrasonic(int id, Firmware.Host host, int trigger, int listened) {
        this.id = id;
        this.host = host;
        this.trigger = trigger;
        this.listened = listened;
        host.pins().setMode(listened, Pins.Mode.INPUT);
        if (trigger != listened) {
            host.pins().setMode(trigger, Pins.Mode.OUTPUT);
        }
    }

    void setRanging(boolean on) {
        ranging = on;
    }

    @Override
    public void detach() {
        ranging = false;
    }

    @Override
    public void loop(double time) {
        if (!ranging || time < next) {
            return;
        }
        double echo = host.pins().echo(trigger, listened);
        boolean heard = echo < LONGEST;
        next = time + (heard ? echo : LONGEST);
        int centimetres = heard ? (int) (
            (Math.round(echo / MICROSECOND) + MICROS_A_CENTIMETRE / 2) / MICROS_A_CENTIMETRE) : 0;
        if (centimetres != last) {
            last = centimetres;
            host.send(MrlMessage.of(MrlFunction.PUBLISH_ULTRASONIC).add(id).addShort(centimetres).end()
                .toBytes(), next);
        }
    }
}
