// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.util.Map;
import org.junit.Test;

/** The next call undoes a call that was killed before any of its changes of the disk. */
public class InstallJournalTest extends LaidOutMrl {
    private static final String UNDONE = "An earlier call was interrupted. Its changes were undone.";

    /** At least the journal and two files, with two changes of the disk each, and the end. */
    private static final int LEAST_STEPS = 7;

    /** An error that no catch clause of the installer handles. */
    private static final class Killed extends Error {
        private static final long serialVersionUID = 1L;
    }

    /** Makes a new plan for each attempt. */
    private interface Planning {
        InstallPlan plan() throws Exception;
    }

    /**
     * Kills before the first step, then before the second, and so on until one attempt completes; each killed attempt
     * leaves everything unchanged.
     * @return the tree after the complete attempt
     */
    private Map<String, String> killEverywhere(Planning planning) throws Exception {
        Map<String, String> before = tree();
        for (int step = 0;; step++) {
            InstallPlan plan = planning.plan();
            int[] left = {step};
            plan.beforeStep = () -> {
                if (left[0]-- == 0) {
                    throw new Killed();
                }
            };
            boolean killed = false;
            try {
                plan.apply();
            } catch (Killed e) {
                killed = true;
            }
            boolean begun = Files.exists(mrl.resolve(".sear-install-journal.json"));
            assertEquals("killed before step " + step, begun ? UNDONE : null, new Installer(mrl).recovered);
            if (!killed) {
                assertFalse(begun);
                assertTrue("only " + step + " steps", step >= LEAST_STEPS);
                return tree();
            }
            assertEquals("killed before step " + step, before, tree());
        }
    }

    @Test
    public void installUpdateAndRemoveCanBeKilledAnywhere() throws Exception {
        jar(mrl.resolve("libraries/jar/jme3-core-3.3.2-stable.jar"), "3.3.2", "com/jme3/math/Vector3f.class");
        Files.delete(mrl.resolve("libraries/jar/jme3-core-3.6.1-stable.jar"));
        Map<String, String> before = tree();
        killEverywhere(() -> new Installer(mrl).install(plugin, true));
        payload("1.1.0");
        killEverywhere(() -> new Installer(mrl).install(plugin, false));
        assertEquals(before, killEverywhere(() -> new Installer(mrl).remove()));
    }
}
