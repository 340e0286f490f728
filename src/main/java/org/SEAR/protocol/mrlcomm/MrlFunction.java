// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.mrlcomm;

/**
 * Functions of version 68, with a pattern of their arguments: b one byte, s two, i four, f a four-byte float, l a text
 * or list (a length byte and its bytes).
 */
public enum MrlFunction {
    PUBLISH_ERROR(1, "l"), GET_BOARD_INFO(2, ""), PUBLISH_BOARD_INFO(3, "bbssbl"), ENABLE_PIN(4, "bbs"),
        SET_DEBUG(5, "b"), SET_SERIAL_RATE(6, "i"),
    SOFT_RESET(7, ""), ENABLE_ACK(8, "b"), PUBLISH_ACK(9, "b"), ECHO(10, "fbf"), PUBLISH_ECHO(11, "fbf"),
    CUSTOM_MSG(12, "l"),
    PUBLISH_CUSTOM_MSG(13, "l"), DEVICE_DETACH(14, "b"), I2C_BUS_ATTACH(15, "bb"), I2C_READ(16, "bbb"),
    I2C_WRITE(17, "bbl"), I2C_WRITE_READ(18, "bbbb"), PUBLISH_I2C_DATA(19, "bl"), NEOPIXEL_ATTACH(20, "bbsb"),
    NEOPIXEL_ANIMATION(21, "bbbbbbi"),
    NEOPIXEL_WRITE(22, "bl"), NEOPIXEL_FILL(23, "bssbbbb"), NEOPIXEL_BRIGHTNESS(24, "bb"), NEOPIXEL_CLEAR(25, "b"),
    ANALOG_WRITE(26, "bb"),
    DIGITAL_WRITE(27, "bb"), DISABLE_PIN(28, "b"), DISABLE_PINS(29, ""), PIN_MODE(30, "bb"), PUBLISH_DEBUG(31, "l"),
    PUBLISH_PIN_ARRAY(32, "l"),
    SET_TRIGGER(33, "bb"), SET_DEBOUNCE(34, "bb"), SERVO_ATTACH(35, "bbssl"), SERVO_ATTACH_PIN(36, "bb"),
    SERVO_DETACH_PIN(37, "b"),
    SERVO_SET_VELOCITY(38, "bs"), SERVO_SWEEP_START(39, "bbbb"), SERVO_SWEEP_STOP(40, "b"), SERVO_MOVE(41, "bs"),
    SERVO_SET_ACCELERATION(42, "bs"),
    PUBLISH_SERVO_EVENT(43, "bbss"), SERIAL_ATTACH(44, "bb"), SERIAL_RELAY(45, "bl"), PUBLISH_SERIAL_DATA(46, "bl"),
    ULTRASONIC_ATTACH(47, "bbb"),
    ULTRASONIC_START(48, "b"), ULTRASONIC_STOP(49, "b"), PUBLISH_ULTRASONIC(50, "bs"), SET_AREF(51, "s"),
    MOTOR_ATTACH(52, "bbl"),
    MOTOR_MOVE(53, "bb"), MOTOR_MOVE_TO(54, "bb"), ENCODER_ATTACH(55, "bbb"), SET_ZERO_POINT(56, "b"),
    PUBLISH_ENCODER(57, "bs"), PUBLISH_BEGIN(58, "b"), SERVO_STOP(59, "b");

    private static final MrlFunction[] BY_NUMBER = values();

    private final int number;
    private final String arguments;

    MrlFunction(int number, String arguments) {
        this.number = number;
        this.arguments = arguments;
    }

    /** Finds a function by number; null if this version does not have it. */
    public static MrlFunction of(int number) {
        return number >= 1 && number <= BY_NUMBER.length ? BY_NUMBER[number - 1] : null;
    }

    /** Byte of the function. */
    public int getNumber() {
        return number;
    }

    /** Whether the bytes suffice for the function's arguments. */
    boolean fits(byte[] bytes) {
        int at = 0;
        for (int i = 0; i < arguments.length(); i++) {
            switch (arguments.charAt(i)) {
                case 'b':
                    at++;
                    break;
                case 's':
                    at += Short.BYTES;
                    break;
                case 'l':
                    at += at < bytes.length ? 1 + (bytes[at] & 0xFF) : 1;
                    break;
                default:
                    at += Integer.BYTES;
                    break;
            }
        }
        return at <= bytes.length;
    }
}
