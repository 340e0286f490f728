// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import static org.junit.Assert.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** Reports of long work. */
public class LongWorkTest {
    private long seconds;

    @Test
    public void reportsComeAfterTwoSecondsAndEachDoublingToTheThreadsListener() {
        List<String> reports = new ArrayList<>();
        LongWork work = new LongWork("model tree: reading tree.blend", () -> seconds * 1_000_000_000);
        Runnable end = LongWork.listen(reports::add);
        for (; seconds < 9; seconds++) {
            work.report(seconds / 10.0);
        }
        seconds = 40;
        work.report();
        assertEquals("next at 64 s", 24_000_000_000L, work.untilReport());
        end.run();
        seconds = 100;
        work.report();
        assertEquals(List.of("model tree: reading tree.blend: 20 %, 2 s so far",
            "model tree: reading tree.blend: 40 %, 4 s so far", "model tree: reading tree.blend: 80 %, 8 s so far",
            "model tree: reading tree.blend: 40 s so far"), reports);
    }
}
