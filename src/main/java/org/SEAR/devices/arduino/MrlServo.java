// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import org.SEAR.protocol.mrlcomm.MrlFunction;
import org.SEAR.protocol.mrlcomm.MrlMessage;

/**
 * A servo of MrlComm. It changes its pulse length towards a target at a set speed, and reports start and arrival. A
 * sweep goes back and forth by one step per loop.
 */
final class MrlServo implements MrlDevice {
    private static final int STARTED = 0;
    private static final int STOPPED = 1;
    /**
     * Target from which the velocity means degrees per second and is converted to us per second; below, it is us per
     * second.
     */
    private static final int FIRST_PULSE = 500;
    private static final double MICROS_A_DEGREE = (2400 - 544) / 180.0;
    private static final int ACCELERATION_SHARE = 10;

    private final int id;
    private final Firmware.Host host;
    private int pin;
    private boolean attached;
    private double position;
    private int target;
    private int velocity;
    private int acceleration = -1;
    private boolean moving;
    private boolean sweeping;
    private int least;
    private int most;
    private double sweepStep;
    private double began;
    private double last;

    /**
     * Attaches the servo to a pin, at its first position.
     *
     * @param velocity degrees per second; below 0: unlimited
     */
    MrlServo(int id, Firmware.Host host, int pin, int position, int velocity) {
        this.id = id;
        this.host = host;
        this.position = position;
        this.target = position;
        this.velocity = velocity;
        attach(pin);
    }

    void attach(int newPin) {
        if (attached && newPin != pin) {
            detach();
        }
        pin = newPin;
        attached = true;
        write();
    }

    @Override
    public void detach() {
        if (attached) {
            host.pins().setMode(pin, Pins.Mode.OUTPUT);
        }
        attached = false;
    }

    private void write() {
        if (attached) {
            host.pins().writePulse(pin, Math.max(0, (int) position));
        }
    }

    void setVelocity(int newVelocity) {
        velocity = newVelocity;
    }

    void setAcceleration(int newAcceleration) {
        acceleration = newAcceleration;
    }

    void move(int micros, double time) {
        target = micros;
        moving = true;
        sweeping = false;
        began = time;
        last = time;
        report(STARTED, time);
    }

    void sweep(int from, int to, int step) {
        least = from;
        most = to;
        sweepStep = step;
        target = to;
        moving = true;
        sweeping = true;
    }

    void stop() {
        moving = false;
        sweeping = false;
    }

    private void report(int event, double time) {
        host.send(MrlMessage.of(MrlFunction.PUBLISH_SERVO_EVENT).add(id).add(event).addShort((int) position)
            .addShort(target).end().toBytes(), time);
    }

    @Override
    public void loop(double time) {
        if (!moving) {
            return;
        }
        if ((int) position == target) {
            arrive(time);
            return;
        }
        double step = sweeping ? Math.abs(sweepStep) : step(time);
        last = time;
        double left = target - position;
        position = Math.abs(left) <= step ? target : position + Math.signum(left) * step;
        write();
    }

    private double step(double time) {
        if (velocity < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double speed = velocity;
        if (acceleration != -1) {
            speed = Math.min(speed, Math.max(
                0, speed * acceleration * (time - began) * (time - began) / ACCELERATION_SHARE));
        }
        return (target > FIRST_PULSE ? speed * MICROS_A_DEGREE : speed) * (time - last);
    }

    private void arrive(double time) {
        if (sweeping) {
            target = target == least ? most : least;
        } else {
            moving = false;
            report(STOPPED, time);
        }
    }
}
