package org.SEAR;

/**
 * How much the fuzz tests try, and with which seed: {@code -Dsear.fuzzBytes=100000000} bytes a device, {@code -Dsear.fuzz=100000} changed files of
 * each kind, {@code -Dsear.fuzzSeed=N} for the same as a run that has printed N. The seed is another one each time.
 */
public final class Fuzz {
    /** Random bytes for each device and each reader. */
    public static final int BYTES = Integer.getInteger("sear.fuzzBytes", 1_000_000);
    /** Changed bundles, and as many changed models. */
    public static final int FILES = Integer.getInteger("sear.fuzz", 2000);
    /** What the tests' random numbers begin with. */
    public static final long SEED = seed();

    private Fuzz() {
    }

    private static long seed() {
        long seed = Long.getLong("sear.fuzzSeed", System.nanoTime());
        System.out.println("fuzz: " + BYTES + " bytes a device, " + FILES + " bundles, " + FILES + " models, -Dsear.fuzzSeed=" + seed);
        return seed;
    }
}
