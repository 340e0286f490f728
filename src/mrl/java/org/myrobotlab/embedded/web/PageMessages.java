// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

/** Converts published data for pages. */
final class PageMessages {
    private PageMessages() {
    }

    /** Converts bytes to numbers from -128 to 127, as scripts get them. */
    static Object[] data(Object... values) {
        Object[] data = new Object[values.length];
        for (int i = 0; i < data.length; i++) {
            data[i] = values[i] instanceof byte[] ? numbers((byte[]) values[i]) : values[i];
        }
        return data;
    }

    private static int[] numbers(byte... bytes) {
        int[] numbers = new int[bytes.length];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = bytes[i];
        }
        return numbers;
    }
}
