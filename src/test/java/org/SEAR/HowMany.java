package org.SEAR;

/**
 * How much the tests try that try very many things: a fifth of it by default, all of it with {@code ./gradlew -Pfull}, and any other number by a
 * property of its own, as {@code -Dsear.drops=100000}.
 */
public final class HowMany {
    /** Whether {@code -Pfull} was given. */
    static final boolean FULL = Boolean.getBoolean("sear.full");
    private static final int PART = 5;

    private HowMany() {
    }

    /**
     * A number of tries.
     *
     * @param property the name of the system property that says another one
     * @param full how many with {@code -Pfull}
     */
    public static int of(String property, int full) {
        return Integer.getInteger(property, FULL ? full : full / PART);
    }
}
