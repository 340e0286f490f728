package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.junit.Test;

/** A call that is killed before any one of its changes of the disk is undone or finished by the next. */
public class InstallJournalTest extends LaidOutMrl {
    private static final String UNDONE = "An earlier call was interrupted. What it had begun was undone.";
    private static final String FINISHED = "An earlier call was interrupted. What it had begun was finished.";

    /** No catch clause of the installer is meant for this. */
    private static final class Killed extends Error {
        private static final long serialVersionUID = 1L;
    }

    /** What is planned anew for each attempt. */
    private interface Planning {
        InstallPlan plan() throws Exception;
    }

    /**
     * Kills before the first step, the second, ..., until one goes through; each time the tree is as before or as after.
     *
     * @return after
     */
    private Map<String, String> killEverywhere(Planning planning) throws Exception {
        Map<String, String> before = tree();
        Map<Integer, Map<String, String>> states = new TreeMap<>();
        Set<String> said = new HashSet<>();
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
            String recovered = new Installer(mrl).recovered;
            if (!killed) {
                assertEquals(null, recovered);
                break;
            }
            states.put(step, tree());
            said.add(recovered);
            if (FINISHED.equals(recovered)) {
                restore(before);
            }
        }
        Map<String, String> after = tree();
        // journal, two files at least, journal, each with two moves of the disk, and the end
        assertTrue("only " + states.size() + " steps", states.size() >= 10);
        states.forEach((step, state) -> assertTrue("killed before step " + step + ": " + state.keySet(),
            state.equals(before) || state.equals(after)));
        assertTrue("both were seen", states.containsValue(before) && states.containsValue(after));
        assertTrue(said.toString(), said.containsAll(List.of(UNDONE, FINISHED)));
        return after;
    }

    private void restore(Map<String, String> tree) throws Exception {
        delete(mrl);
        for (Map.Entry<String, String> file : tree.entrySet()) {
            if (file.getKey().endsWith("/")) {
                Files.createDirectories(mrl.resolve(file.getKey()));
            } else {
                Files.write(mrl.resolve(file.getKey()), file.getValue().getBytes(StandardCharsets.ISO_8859_1));
            }
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
        assertEquals(before, killEverywhere(() -> new Installer(mrl).remove(plugin)));
    }
}
