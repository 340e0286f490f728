package org.SEAR.project.models;

import static org.junit.Assert.assertNotNull;

import com.jme3.util.TempVars;
import org.junit.Test;

/** A thread on which loads of models have failed can load the next one. */
public class EngineScratchTest {
    @Test
    public void whatALoaderTookAndDidNotGiveBackIsFreeAgain() {
        for (int i = 0; i < 20; i++) {
            EngineScratch scratch = new EngineScratch();
            assertNotNull(TempVars.get());
            assertNotNull(TempVars.get());
            scratch.giveBack();
        }
    }

    @Test
    public void whatTheCallerHoldsStaysHis() {
        TempVars held = TempVars.get();
        EngineScratch scratch = new EngineScratch();
        assertNotNull(TempVars.get());
        scratch.giveBack();
        TempVars next = TempVars.get();
        next.release();
        held.release();
    }
}
