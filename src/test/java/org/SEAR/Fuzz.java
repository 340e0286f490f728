package org.SEAR;

/**
 * How much the fuzz tests try, and with which seed: {@code -Dsear.fuzzBytes=100000000} bytes a device, {@code -Dsear.fuzz=100000} changed files of
 * each kind, {@code -Dsear.fuzzSeed=N} for the same as a run that has printed N. The seed is always the same, so that no commit fails at what it has
 * not changed, and another one each time with {@code -Pfull}.
 */
public final class Fuzz {
    /** Random bytes for each device and each reader. */
    public static final int BYTES = HowMany.of("sear.fuzzBytes", 1_000_000);
    /** Changed bundles, and as many changed models. */
    public static final int FILES = HowMany.of("sear.fuzz", 2000);
    private static final long FIXED_SEED = 1;
    /** What the tests' random numbers begin with. */
    public static final long SEED = seed();

    private Fuzz() {
    }

    private static long seed() {
        long seed = Long.getLong("sear.fuzzSeed", HowMany.FULL ? System.nanoTime() : FIXED_SEED);
        System.out.println("fuzz: " + BYTES + " bytes a device, " + FILES + " bundles, " + FILES + " models, -Dsear.fuzzSeed=" + seed);
        return seed;
    }
}
