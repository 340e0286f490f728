// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.web.MyRobotLab;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;

/**
 * {@code sear} is killed like {@code kill -9} during a stream of edits and undos, and started again. Every answered
 * edit is present, the one in flight wholly or not at all, and undo reverts all of them. {@code -Dsear.kills=100} sets
 * the number of kills.
 */
public class KilledWhileEditingTest {
    private static final long SEED = 21;
    private static final int KILLS = Integer.getInteger("sear.kills", 3);
    /** Number of kills after which all edits are undone; undo has 500 steps. */
    private static final int IN_A_ROW = 10;
    private static final int FEWEST_EDITS = 3;
    private static final int MORE_EDITS = 25;
    /** About the duration of an edit, microseconds. */
    private static final int LONGEST_MICROS = 20000;
    private static final double UNDOS = 0.25;
    private static final long PATIENCE_SECONDS = 180;

    private final Random random = new Random(SEED);
    private MyRobotLab robotLab;
    /** Number of edits done and not undone, which determines the project. */
    private int depth;

    @Before
    public void start() throws Exception {
        robotLab = new MyRobotLab("Runtime.start('sear', 'SEAR')");
    }

    @After
    public void stop() {
        robotLab.close();
    }

    /** Returns an edit of several files: a new box, a deletion and a change. */
    private static Map<String, Object> edit(int number) {
        List<Map<String, Object>> edits = new ArrayList<>();
        edits.add(Map.of("do", "add", "type", "Box", "name", "box" + number, "set", Map.of("x", number, "mass", 1)));
        if (number == 1) {
            edits.add(Map.of("do", "add", "type", "Sphere", "name", "last"));
        } else if (number % 2 == 0) {
            edits.add(Map.of("do", "delete", "object", "box" + (number - 1)));
        }
        edits.add(Map.of("do", "set", "object", "last", "set", Map.of("z", number)));
        return Map.of("do", "all", "words", "edit " + number, "edits", edits);
    }

    /** Returns the x values by name after this number of edits. */
    private static Map<String, String> wanted(int edits) {
        Map<String, String> things = new TreeMap<>();
        for (int i = 1; i <= edits; i++) {
            if (i % 2 == 0 || i == edits) {
                things.put("box" + i, Integer.toString(i));
            }
        }
        if (edits > 0) {
            things.put("last", "z " + edits);
        }
        return things;
    }

    private Map<String, String> found() throws Exception {
        Map<String, String> things = new TreeMap<>();
        for (String file : objects().keySet()) {
            String name = file.substring(file.lastIndexOf('/') + 1).replace(".xml", "");
            JsonNode values = robotLab.call("sear", "getProjectObject", name).get("values");
            things.put(name, name.equals("last") ? "z " + values.get("z").asText() : values.get("x").asText());
        }
        return things;
    }

    /** Returns the objects without the undo journal and temporary files of a killed process. */
    private Map<String, String> objects() throws IOException {
        Map<String, String> files = ProjectRule.files(robotLab.file("SEARproject"));
        files.keySet().removeIf(file -> file.startsWith(".edits/") || file.endsWith(".tmp"));
        return files;
    }

    /** Edits and undoes until it is killed. */
    private final class Stream implements Runnable {
        private final Random choice = new Random(random.nextLong());
        private final AtomicBoolean killed = new AtomicBoolean();
        private final CountDownLatch enough = new CountDownLatch(FEWEST_EDITS + random.nextInt(MORE_EDITS));
        private final Thread thread = new Thread(this, "edits");
        /** {@link KilledWhileEditingTest#depth} without and with the edit that has no answer yet. */
        private volatile int[] depths = {depth, depth};
        private volatile Throwable failure;

        @Override
        public void run() {
            try {
                while (true) {
                    int now = depths[0];
                    boolean undoes = now > 1 && choice.nextDouble() < UNDOS;
                    depths = new int[] {now, undoes ? now - 1 : now + 1};
                    if (undoes) {
                        robotLab.call("sear", "undo");
                    } else {
                        robotLab.call("sear", "edit", edit(now + 1));
                    }
                    depths = new int[] {depths[1], depths[1]};
                    enough.countDown();
                }
            } catch (AssertionError e) {
                failure = killed.get() ? null : e;
                while (enough.getCount() > 0) {
                    enough.countDown();
                }
            }
        }

        void kill() throws InterruptedException {
            thread.start();
            assertTrue("edits", enough.await(PATIENCE_SECONDS, TimeUnit.SECONDS));
            LockSupport.parkNanos(TimeUnit.MICROSECONDS.toNanos(random.nextInt(LONGEST_MICROS)));
            killed.set(true);
            robotLab.kill();
            thread.join(TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
            if (failure != null) {
                throw new AssertionError("an edit was refused", failure);
            }
        }
    }

    @Test
    public void atMostTheEditInFlightIsLostAndUndoStillWorks() throws Exception {
        Path folder = robotLab.file("SEARproject");
        for (int kill = 0; kill < KILLS; kill++) {
            Stream stream = new Stream();
            stream.kill();
            robotLab.startAgain();
            Project.read(folder);
            int[] depths = stream.depths;
            Map<String, String> found = found();
            depth = found.equals(wanted(depths[1])) ? depths[1] : depths[0];
            assertEquals("kill " + kill + " after " + depths[0] + " edits", wanted(depth), found);
            assertEquals("edit " + depth, robotLab.call("sear", "getEdits").get("undo").asText());
            Map<String, String> before = objects();
            assertEquals("edit " + depth, robotLab.call("sear", "undo").get("words").asText());
            assertEquals(wanted(depth - 1), found());
            robotLab.call("sear", "redo");
            assertEquals(before, objects());
            if ((kill + 1) % IN_A_ROW == 0) {
                takeAllBack();
            }
        }
        takeAllBack();
    }

    private void takeAllBack() throws IOException {
        while (depth > 0) {
            assertEquals("edit " + depth--, robotLab.call("sear", "undo").get("words").asText());
        }
        assertEquals(Map.of(), objects());
    }
}
