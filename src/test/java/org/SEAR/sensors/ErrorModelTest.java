// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Noise;
import org.SEAR.Slow;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Measurement errors have the statistics of their parameters and depend only on seed, name and step. */
@Category(Slow.class)
public class ErrorModelTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static final int MANY = 100_000;
    private static final String GOLDEN = "869258717843210468 0.917116529229873 1.8179767551456791";

    private static ErrorModel model(String name, long seed, Noise noise) {
        Compass parameters = new Compass(name);
        parameters.setNoise(noise);
        return ErrorModel.of(parameters, seed, 2);
    }

    private static double[] meanAndDeviation(double[] values) {
        double sum = 0;
        double squares = 0;
        for (double value : values) {
            sum += value;
            squares += value * value;
        }
        double mean = sum / values.length;
        return new double[] {mean, Math.sqrt(squares / values.length - mean * mean)};
    }

    @Test
    public void withoutNoiseValuesPass() {
        ErrorModel none = ErrorModel.of(new Compass("quiet"), 1, 2);
        assertSame(ErrorModel.NONE, none);
        assertEquals(1.234, none.apply(1.234, 5, 0, 0), 0);
        assertFalse(none.drops(5, 0));
        assertTrue(none.isNone());
    }

    @Test
    public void whiteNoiseHasItsDeviationAndNoMemory() {
        ErrorModel model = model("white", 1, new Noise().setWhite(0.5));
        double[] values = new double[MANY];
        double product = 0;
        for (int i = 0; i < MANY; i++) {
            values[i] = model.apply(10, i, 0, 0) - 10;
            product += i == 0 ? 0 : values[i] * values[i - 1];
        }
        assertEquals(0, meanAndDeviation(values)[0], 0.5 * 4 / Math.sqrt(MANY));
        assertEquals(0.5, meanAndDeviation(values)[1], 0.005);
        assertEquals("neighbouring steps are independent", 0, product / MANY / 0.25, 4 / Math.sqrt(MANY));
        int beyond = 0;
        for (double value : values) {
            beyond += Math.abs(value) > 1 ? 1 : 0;
        }
        assertEquals("4.55 % of a normal lie beyond two deviations", 0.0455, beyond / (double) MANY, 0.003);
    }

    @Test
    public void samplesAndAxesOfOneStepAreIndependent() {
        ErrorModel model = model("white", 1, new Noise().setWhite(1));
        double product = 0;
        for (int i = 0; i < MANY; i++) {
            product += model.apply(0, i, 0, 0) * model.apply(0, i, 0, 1);
        }
        assertEquals(0, product / MANY, 4 / Math.sqrt(MANY));
    }

    @Test
    public void biasQuantisationAndDropOutAreExact() {
        assertEquals(2.25, model("bias", 1, new Noise().setBias(0.25)).apply(2, 9, 0, 0), 0);
        ErrorModel steps = model("steps", 1, new Noise().setQuantisation(0.5));
        assertEquals(2.5, steps.apply(2.25, 9, 0, 0), 0);
        assertEquals(2, steps.apply(2.2499, 9, 0, 0), 0);
        assertEquals(-2, steps.apply(-2.25, 9, 0, 0), 0);
        ErrorModel lossy = model("lossy", 1, new Noise().setDropout(0.3));
        int lost = 0;
        for (int i = 0; i < MANY; i++) {
            lost += lossy.drops(i, 0) ? 1 : 0;
        }
        assertEquals(0.3, lost / (double) MANY, 0.006);
        assertEquals("what doesn't drop out is exact", 7, lossy.apply(7, 1, 0, 0), 0);
    }

    @Test
    public void driftGrowsWithTheSquareRootOfTime() {
        int walks = 2000;
        double[] ends = new double[walks];
        double[] others = new double[walks];
        for (int walk = 0; walk < walks; walk++) {
            ErrorModel model = model("drift", walk, new Noise().setDrift(0.1));
            ScriptedTruth truth = new ScriptedTruth();
            for (int i = 0; i < 240; i++) {
                truth.step++;
                model.track(truth);
            }
            ends[walk] = model.apply(0, truth.step, 0, 0);
            others[walk] = model.apply(0, truth.step, 1, 1);
        }
        assertEquals("4 s at 0.1 per square root of a second", 0.2, meanAndDeviation(ends)[1], 0.2 * 0.06);
        assertEquals(0, meanAndDeviation(ends)[0], 0.2 * 4 / Math.sqrt(walks));
        assertEquals(0.2, meanAndDeviation(others)[1], 0.2 * 0.06);
        assertTrue(ends[0] != others[0]);
    }

    @Test
    public void driftDoesNotDependOnReaders() {
        ErrorModel one = model("drift", 4, new Noise().setDrift(0.1).setWhite(0.2));
        ErrorModel two = model("drift", 4, new Noise().setDrift(0.1).setWhite(0.2));
        ScriptedTruth truth = new ScriptedTruth();
        for (int i = 0; i < 100; i++) {
            truth.step++;
            one.track(truth);
            two.track(truth);
            two.apply(1, truth.step, 0, 0);
            two.apply(1, truth.step, 1, 1);
        }
        assertEquals(one.apply(1, truth.step, 1, 1), two.apply(1, truth.step, 1, 1), 0);
        one.reset();
        truth.step = 0;
        assertEquals(model("drift", 4, new Noise().setDrift(0.1).setWhite(0.2)).apply(1, 0, 0, 0),
            one.apply(1, 0, 0, 0), 0);
    }

    @Test
    public void numbersDependOnSeedNameStepStreamAndIndexOnly() {
        Set<Long> seen = new HashSet<>();
        int count = 0;
        for (String name : new String[] {"a", "b", "ab", "ba", ""}) {
            for (long seed = -2; seed < 3; seed++) {
                for (long step = 0; step < 20; step++) {
                    for (int stream = 0; stream < 4; stream++) {
                        for (int index = 0; index < 20; index++) {
                            seen.add(new CounterRandom(seed, name).bits(step, stream, index));
                            count++;
                        }
                    }
                }
            }
        }
        assertEquals("no number comes twice", count, seen.size());
    }

    @Test
    public void theGeneratorsNumbersAreForEver() {
        CounterRandom random = new CounterRandom(42, "ping");
        assertEquals("saved runs replay with later versions", GOLDEN, random.bits(1, 2, 3) + " "
            + random.uniform(4, 5, 6) + " " + random.normal(7, 8, 9));
    }

    @Test
    public void uniformNumbersAreUniform() {
        CounterRandom random = new CounterRandom(42, "ping");
        int[] bins = new int[100];
        for (int i = 0; i < MANY; i++) {
            double value = random.uniform(i, 0, 0);
            assertTrue(value >= 0 && value < 1);
            bins[(int) (value * 100)]++;
        }
        double chiSquare = 0;
        for (int bin : bins) {
            chiSquare += (bin - MANY / 100.0) * (bin - MANY / 100.0) / (MANY / 100.0);
        }
        assertTrue("chi square of 99 degrees of freedom: " + chiSquare, chiSquare > 56 && chiSquare < 157);
    }
}
