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

    @Test
    public void aHeapComesToRest() throws Exception {
        DropScenes.pile(100, findings);
        findings.assertHold();
    }
}
