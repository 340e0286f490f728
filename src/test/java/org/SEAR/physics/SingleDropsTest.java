package org.SEAR.physics;

import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** What is dropped singly comes to rest on a face, a rim or a side; {@code -Dsear.singles=1000} drops so many for each seed. */
@Category(Slow.class)
public class SingleDropsTest {
    private static final int SINGLES = Integer.getInteger("sear.singles", 200);

    private final Findings findings = new Findings();

    @Test
    public void everythingThatIsDroppedComesToRestAsItCanLie() throws Exception {
        for (long seed = 1; seed <= 3; seed++) {
            DropScenes.single(SINGLES, seed, findings);
        }
        findings.assertHold();
    }

    @Test
    public void noCubeGainsEnergyByLanding() throws Exception {
        DropScenes.landing(300, findings);
        findings.assertHold();
    }

    /**
     * The first three sway on without a brake on what rocks, for in them a cube hangs between others by its corners; the others with one pass in a
     * substep, for each hears too late of the others.
     */
    @Test
    public void heapsComeToRest() throws Exception {
        for (long seed : new long[] {15, 21, 37, 57, 58, 67}) {
            DropScenes.pile(100, seed, findings);
        }
        findings.assertHold();
    }

    /** So many that each has many others about it. */
    @Test
    public void aHeapOfManyIsNotInItself() throws Exception {
        DropScenes.pile(500, 1, findings);
        findings.assertHold();
    }
}
