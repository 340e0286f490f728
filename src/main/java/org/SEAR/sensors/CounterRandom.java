// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/**
 * Random numbers as a function of (seed, name, step, stream, index) only. The order and number of calls do not matter.
 * Immutable; any thread; allocates nothing.
 *
 * <p>Each number is the finaliser of SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number
 * generators", 2014) over the counters. {@link StrictMath} makes the normal numbers the same on every machine.
 */
public final class CounterRandom {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;
    private static final long FIRST = 0xBF58476D1CE4E5B9L;
    private static final long SECOND = 0x94D049BB133111EBL;
    private static final double UNIT = 0x1.0p-53;

    private final long key;

    /**
     * @param seed random seed of the simulation
     * @param name owner of these numbers
     */
    public CounterRandom(long seed, String name) {
        long state = mix(seed + GOLDEN);
        for (int i = 0; i < name.length(); i++) {
            state = mix(state + GOLDEN + name.charAt(i));
        }
        this.key = state;
    }

    /**
     * Returns 64 random bits.
     *
     * @param stream purpose of the numbers
     * @param index number within this step and stream
     */
    public long bits(long step, int stream, int index) {
        long state = mix(key + GOLDEN * (step + 1));
        return mix(state + GOLDEN * (((long) stream << 32) + index + 1));
    }

    /** Returns a uniform number in [0, 1). */
    public double uniform(long step, int stream, int index) {
        return (bits(step, stream, index) >>> 11) * UNIT;
    }

    /** Returns a normal number with mean 0 and standard deviation 1 (Box-Muller). */
    public double normal(long step, int stream, int index) {
        long bits = bits(step, stream, index);
        double radius = ((bits >>> 11) + 1) * UNIT;
        double angle = (mix(bits + GOLDEN) >>> 11) * UNIT;
        return StrictMath.sqrt(-2 * StrictMath.log(radius)) * StrictMath.cos(2 * Math.PI * angle);
    }

    private static long mix(long value) {
        long z = (value ^ (value >>> 30)) * FIRST;
        z = (z ^ (z >>> 27)) * SECOND;
        return z ^ (z >>> 31);
    }
}
