// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.junit.Test;

/** Contacts along a line carry a load at both ends of the line. */
public class LogsTest {
    private final Findings findings = new Findings();

    @Test
    public void aLogRestsOnLogsRailsAndConesAlongItsLength() throws Exception {
        LogScenes.onFixedLogs(5, findings);
        LogScenes.onRails(2, findings);
        LogScenes.coneOnCones(2, findings);
        findings.assertHold();
    }

    @Test
    public void aPileOfThreeLogsStandsFromTheFrictionOfTheClosedFormOn() throws Exception {
        LogScenes.pile(1, 0.271, 0.64, 3, true, findings);
        LogScenes.pile(1, 0.36, 0.0905, 3, true, findings);
        LogScenes.pile(3, 0.64, 0.64, 2, true, findings);
        LogScenes.pile(1, 1, 0.64, 3, true, findings);
        LogScenes.pile(1, 0.265, 0.64, 3, false, findings);
        LogScenes.pile(1, 0.36, 0.088, 3, false, findings);
        findings.assertHold();
    }

    @Test
    public void aLogRollsOffALogAsInTheClosedForm() throws Exception {
        LogScenes.overLog(findings);
        findings.assertHold();
    }

    @Test
    public void rowsOfLogsBetweenStopsStand() throws Exception {
        LogScenes.rows(6, 3, findings);
        LogScenes.rows(10, 2, findings);
        findings.assertHold();
    }
}
