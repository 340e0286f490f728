// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

/**
 * Repetitions of tests that try many cases: a fifth by default, all with {@code ./gradlew -Pfull}, and any other number
 * by a property of the test, such as {@code -Dsear.drops=100000}.
 */
public final class HowMany {
    /** Whether {@code -Pfull} was given. */
    static final boolean FULL = Boolean.getBoolean("sear.full");
    private static final int PART = 5;

    private HowMany() {
    }

    public static int of(String property, int full) {
        return Integer.getInteger(property, FULL ? full : full / PART);
    }
}
