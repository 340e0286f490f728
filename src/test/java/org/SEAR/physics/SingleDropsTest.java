package org.SEAR.physics;

import org.junit.Test;

/** What is dropped singly comes to rest on a face, a rim or a side; {@code -Dsear.singles=1000} drops so many for each seed. */
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

    /** In all but the first a cube hangs between others by its corners: without a brake on what rocks it would swing, and keep all awake. */
    @Test
    public void heapsComeToRest() throws Exception {
        for (long seed : new long[] {1, 10, 13, 16, 18, 29, 35}) {
            DropScenes.pile(100, seed, findings);
        }
        findings.assertHold();
    }
}
