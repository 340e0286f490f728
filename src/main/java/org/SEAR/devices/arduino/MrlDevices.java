// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.SEAR.protocol.arduino.PinUse;
import org.SEAR.protocol.mrlcomm.MrlFunction;
import org.SEAR.protocol.mrlcomm.MrlMessage;

/** Servos and ultrasonic sensors that MyRobotLab services have attached; at most 256, as their numbers are bytes. */
final class MrlDevices {
    private final Firmware.Host host;
    private final Pins pins;
    private final Consumer<String> errors;
    private final Map<Integer, MrlDevice> devices = new TreeMap<>();

    /** @param errors receives error texts for MyRobotLab */
    MrlDevices(Firmware.Host host, Consumer<String> errors) {
        this.host = host;
        this.pins = host.pins();
        this.errors = errors;
    }

    void clear() {
        devices.values().forEach(MrlDevice::detach);
        devices.clear();
    }

    int size() {
        return devices.size();
    }

    /** Returns the number of each device. */
    byte[] summary() {
        byte[] numbers = new byte[devices.size()];
        int at = 0;
        for (Integer number : devices.keySet()) {
            numbers[at++] = number.byteValue();
        }
        return numbers;
    }

    void loop(double time) {
        for (MrlDevice device : devices.values()) {
            device.loop(time);
        }
    }

    /** @return whether the function is one for attached devices */
    boolean execute(MrlFunction function, MrlMessage message, double time) {
        switch (function) {
            case DEVICE_DETACH:
                MrlDevice detached = devices.remove(message.getByte(0));
                if (detached != null) {
                    detached.detach();
                }
                return true;
            case SERVO_ATTACH:
                attachServo(message);
                return true;
            case ULTRASONIC_ATTACH:
                attachUltrasonic(message);
                return true;
            case ULTRASONIC_START:
            case ULTRASONIC_STOP:
                MrlUltrasonic sensor = find(message, MrlUltrasonic.class);
                if (sensor != null) {
                    sensor.setRanging(function == MrlFunction.ULTRASONIC_START);
                }
                return true;
            case SERVO_ATTACH_PIN:
            case SERVO_DETACH_PIN:
            case SERVO_SET_VELOCITY:
            case SERVO_SET_ACCELERATION:
            case SERVO_SWEEP_START:
            case SERVO_SWEEP_STOP:
            case SERVO_STOP:
            case SERVO_MOVE:
                MrlServo servo = find(message, MrlServo.class);
                if (servo != null) {
                    command(servo, function, message, time);
                }
                return true;
            default:
                return false;
        }
    }

    private <D extends MrlDevice> D find(MrlMessage message, Class<D> type) {
        MrlDevice device = devices.get(message.getByte(0));
        if (!type.isInstance(device)) {
            errors.accept("device does not exist");
            return null;
        }
        return type.cast(device);
    }

    private boolean isFree(MrlMessage message, PinUse use, int... wanted) {
        for (int pin : wanted) {
            if (!pins.board().can(pin, use)) {
                errors.accept("pin " + pin + ": legal " + pins.board().pinsFor(use));
                return false;
            }
        }
        boolean free = !devices.containsKey(message.getByte(0));
        if (!free) {
            errors.accept("device already exists");
        }
        return free;
    }

    private void attachServo(MrlMessage message) {
        int pin = message.getByte(1);
        if (isFree(message, PinUse.SERVO, pin)) {
            devices.put(message.getByte(0), new MrlServo(message.getByte(0), host, pin, message.getShort(2),
                message.getShort(4)));
        }
    }

    private void attachUltrasonic(MrlMessage message) {
        int trigger = message.getByte(1);
        int echo = message.getByte(2);
        if (isFree(message, PinUse.DIGITAL, trigger, echo)) {
            devices.put(message.getByte(0), new MrlUltrasonic(message.getByte(0), host, trigger, echo));
        }
    }

    private void command(MrlServo servo, MrlFunction function, MrlMessage message, double time) {
        switch (function) {
            case SERVO_ATTACH_PIN:
                if (pins.board().can(message.getByte(1), PinUse.SERVO)) {
                    servo.attach(message.getByte(1));
                } else {
                    errors.accept("pin " + message.getByte(1) + ": legal " + pins.board().pinsFor(PinUse.SERVO));
                }
                break;
            case SERVO_DETACH_PIN:
                servo.detach();
                break;
            case SERVO_SET_VELOCITY:
                servo.setVelocity(message.getShort(1));
                break;
            case SERVO_SET_ACCELERATION:
                servo.setAcceleration(message.getShort(1));
                break;
            case SERVO_SWEEP_START:
                servo.sweep(message.getByte(1), message.getByte(2), message.getByte(3));
                break;
            case SERVO_MOVE:
                servo.move(message.getShort(1), time);
                break;
            default:
                servo.stop();
                break;
        }
    }
}
