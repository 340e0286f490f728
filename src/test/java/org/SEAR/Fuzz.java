// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

/**
 * Size and seed of the fuzz tests: {@code -Dsear.fuzzBytes=100000000} bytes per device, {@code -Dsear.fuzz=100000}
 * changed files of each kind, {@code -Dsear.fuzzSeed=N} to repeat a run that printed N. The seed is fixed so that no
 * commit fails for something it did not change; with {@code -Pfull} it differs each time.
 */
public final class Fuzz {
    /** Random bytes per device and per reader. */
    public static final int BYTES = HowMany.of("sear.fuzzBytes", 1_000_000);
    /** Number of changed bundles, and of changed models. */
    public static final int FILES = HowMany.of("sear.fuzz", 2000);
    private static final long FIXED_SEED = 1;
    /** Seed of the tests' random numbers. */
    public static final long SEED = seed();

    private Fuzz() {
    }

    private static long seed() {
        long seed = Long.getLong("sear.fuzzSeed", HowMany.FULL ? System.nanoTime() : FIXED_SEED);
        System.out.println("fuzz: " + BYTES + " bytes a device, " + FILES + " bundles, " + FILES
            + " models, -Dsear.fuzzSeed=" + seed);
        return seed;
    }
}
