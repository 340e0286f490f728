// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Test;

/** Threads that a script starts last and that a busy machine runs only later; here they run when the gate opens. */
public class ScriptThreadsTest {
    private static final String NAME = "late";
    private static final int MANY = 50;
    private static final long PATIENCE_MILLIS = TimeUnit.MINUTES.toMillis(10);
    /** Python evaluates this condition on each new thread before the thread's own code. */
    private static final String LATE = String.join("\n", "import threading", "class Late(object):",
        "    def __nonzero__(self):",
        "        gate.await()", "        return False", "threading.settrace(Late())", "ran = []", "");
    private static final String START =
        String.join("\n", "threads = [threading.Thread(target=ran.append, args=(i,)) for i in range(" + MANY + ")]",
        "for one in threads: one.start()", "");

    private final CountDownLatch gate = new CountDownLatch(1);
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final PythonEngine engine = new PythonEngine(NAME, printed, printed);

    @After
    public void end() {
        gate.countDown();
        engine.close();
    }

    private void run(String code) {
        ScriptResult result = engine.run(code);
        assertEquals(result.getTraceback(), 0, result.getExitCode());
    }

    @Test
    public void theEndOfTheScriptWaitsForThreadsThatHaveNotBegunYet() throws InterruptedException {
        engine.set("gate", gate);
        run(LATE + START);
        assertFalse("threads that are yet to begin were taken for ended", engine.finishThreads(1));
        gate.countDown();
        assertTrue(printed.toString(), engine.finishThreads(PATIENCE_MILLIS));
        run("assert sorted(ran) == range(" + MANY + "), ran");
    }

    /** Python waits for such a thread when an interpreter ends, and would wait for ever if the thread ran. */
    @Test
    public void aThreadThatComesAfterTheEndDoesNothing() throws InterruptedException {
        engine.set("gate", gate);
        run(LATE + START);
        Object ran = engine.get("ran");
        Thread closing = new Thread(engine::close, "closing");
        closing.start();
        while (PythonEngine.of(NAME) != null) {
            Thread.onSpinWait();
        }
        gate.countDown();
        closing.join(PATIENCE_MILLIS);
        assertFalse("it waits for threads", closing.isAlive());
        assertEquals("[]", ran.toString());
    }

    @Test
    public void aThreadThatCanNotStartIsNotWaitedFor() throws InterruptedException {
        run("import threading\none = threading.Thread(target=len, args=('',))\none.start()\none.join()\ntry:\n    "
            + "one.start()\n    raise ValueError('started twice')\nexcept RuntimeError:\n    pass\n");
        assertTrue(engine.finishThreads(PATIENCE_MILLIS));
    }
}
