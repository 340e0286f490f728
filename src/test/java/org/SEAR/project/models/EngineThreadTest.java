// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import com.jme3.util.TempVars;
import java.util.concurrent.ExecutionException;
import org.SEAR.files.LongWork;
import org.junit.Test;

/** A thread whose model loads failed can load the next model. */
public class EngineThreadTest {
    private static final LongWork WORK = new LongWork("test");

    @Test
    public void resourcesKeptByALoaderAreReplaced() throws Exception {
        for (int i = 0; i < 20; i++) {
            assertNotNull(EngineThread.call(TempVars::get, WORK));
        }
        TempVars.get().release();
    }

    @Test
    public void anyFailureReachesTheCaller() {
        StackOverflowError deep = new StackOverflowError();
        try {
            EngineThread.call(() -> {
                throw deep;
            }, WORK);
        } catch (ExecutionException e) {
            assertSame(deep, e.getCause());
            return;
        }
        throw new AssertionError("the failure is lost");
    }

    @Test
    public void anInterruptedCallerGetsHisModelAndStaysInterrupted() throws Exception {
        Thread.currentThread().interrupt();
        assertEquals("model", EngineThread.call(() -> "model", WORK));
        assertTrue(Thread.interrupted());
    }
}
