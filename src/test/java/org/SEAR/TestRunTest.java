// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.fail;

import org.junit.Assume;
import org.junit.Ignore;
import org.junit.Test;
import org.junit.runner.JUnitCore;

/** The last line of {@code ./gradlew check} counts correctly on Javas that Gradle's own runner does not support. */
public class TestRunTest {
    /** One test of each result. */
    public static class Mixed {
        @Test
        public void good() {
            assertEquals(2, 1 + 1);
        }

        @Test
        public void bad() {
            fail("on purpose");
        }

        @Test
        public void impossible() {
            Assume.assumeTrue(false);
        }

        @Ignore("on purpose")
        @Test
        public void ignored() {
            fail("never run");
        }
    }

    @Test
    public void passedFailedAndSkippedAreCounted() {
        assertEquals("1 passed, 1 failed, 2 skipped", TestRun.summary(new JUnitCore().run(Mixed.class)));
    }
}
