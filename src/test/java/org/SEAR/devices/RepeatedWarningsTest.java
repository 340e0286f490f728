// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import static org.junit.Assert.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** Repeated warnings of one cause are reported once and then counted. */
public class RepeatedWarningsTest {
    @Test
    public void theFirstIsReportedAndThenOnlyTheCount() {
        RepeatedWarnings repeats = new RepeatedWarnings();
        List<String> told = new ArrayList<>();
        for (int i = 1; i <= 1700; i++) {
            String text = repeats.count("opcode", "opcode " + i + " is unknown");
            if (text != null) {
                told.add(text);
            }
        }
        assertEquals("[opcode 1 is unknown, opcode 10 is unknown (10 times so far), opcode 100 is unknown (100 "
            + "times so far), opcode 1000 is unknown (1000 times so far)]", told.toString());
        assertEquals("another cause", repeats.count("mode", "another cause"));
        repeats.clear();
        assertEquals("opcode 9 is unknown", repeats.count("opcode", "opcode 9 is unknown"));
    }
}
