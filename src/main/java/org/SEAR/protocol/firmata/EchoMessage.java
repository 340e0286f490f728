// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.firmata;

/**
 * Request for an echo and its answer, as in PingFirmata and johnny-five: {@code F0 75 pin level pulse timeout F7} and
 * {@code F0 75 pin duration F7}. Times are microseconds in 32 bits, high byte first, each byte as two of seven bits.
 * The pin of the answer is split, too.
 */
public final class EchoMessage {
    private static final int TIME_SIZE = 8;
    private static final int LEVEL = 1;
    private static final int PULSE = 2;
    private static final int TIMEOUT = PULSE + TIME_SIZE;
    private static final int REQUEST_SIZE = TIMEOUT + TIME_SIZE;
    private static final int BITS = 7;
    private static final int SEVEN_BITS = 0x7F;

    private EchoMessage() {
    }

    /** Whether a message requests an echo. */
    public static boolean isRequest(FirmataMessage message) {
        return message.isSysex() && message.getId() == Feature.ECHO && message.size() == REQUEST_SIZE;
    }

    /** Creates a request for an echo. */
    public static FirmataMessage request(int pin, boolean high, long pulse, long timeout) {
        int[] data = new int[REQUEST_SIZE];
        data[0] = pin;
        data[LEVEL] = high ? 1 : 0;
        put(data, PULSE, pulse);
        put(data, TIMEOUT, timeout);
        return FirmataMessage.sysex(Feature.ECHO, data);
    }

    /** @param micros duration of the echo; 0 if none came in time */
    public static FirmataMessage answer(int pin, long micros) {
        int[] data = new int[2 + TIME_SIZE];
        data[0] = pin & SEVEN_BITS;
        data[1] = pin >> BITS;
        put(data, 2, micros);
        return FirmataMessage.sysex(Feature.ECHO, data);
    }

    /** Timeout of the request, microseconds. */
    public static long timeout(FirmataMessage request) {
        return get(request, TIMEOUT);
    }

    /** Duration of the echo, microseconds. */
    public static long duration(FirmataMessage answer) {
        return get(answer, 2);
    }

    private static void put(int[] data, int at, long value) {
        for (int i = 0; i < TIME_SIZE / 2; i++) {
            int each = (int) (value >> Byte.SIZE * (TIME_SIZE / 2 - 1 - i)) & 0xFF;
            data[at + 2 * i] = each & SEVEN_BITS;
            data[at + 2 * i + 1] = each >> BITS;
        }
    }

    private static long get(FirmataMessage message, int at) {
        long value = 0;
        for (int i = 0; i < TIME_SIZE / 2; i++) {
            value = value << Byte.SIZE | message.getNumber(at + 2 * i) & 0xFF;
        }
        return value;
    }
}
