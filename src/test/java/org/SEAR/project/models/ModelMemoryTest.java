// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.lang.management.BufferPoolMXBean;
import java.lang.management.ManagementFactory;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicInteger;
import org.SEAR.POJOs.Model;
import org.SEAR.Slow;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.embedded.Json;
import org.myrobotlab.service.sear.panel.Preview;

/**
 * A long-lived thread makes many worlds, and none of their models stays in memory. {@code -Dsear.starts=1000} sets
 * their number.
 */
@Category(Slow.class)
public class ModelMemoryTest {
    private static final int STARTS = Integer.getInteger("sear.starts", 20);
    private static final int IDLE_COLLECTIONS = 10;
    private static final long MEGABYTE = 1 << 20;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static long direct() {
        return ManagementFactory.getPlatformMXBeans(BufferPoolMXBean.class).stream()
            .filter(pool -> pool.getName().equals("direct")).mapToLong(BufferPoolMXBean::getMemoryUsed).sum();
    }

    /**
     * Returns the direct memory after garbage collection, once it is at most {@code enough} or several collections
     * freed no more.
     */
    private static long held(long enough) {
        long least = direct();
        for (int idle = 0; idle < IDLE_COLLECTIONS && least > enough; idle++) {
            System.gc();
            System.runFinalization();
            if (direct() < least) {
                least = direct();
                idle = 0;
            }
        }
        return least;
    }

    /** Adds a ground of 45000 triangles. */
    private void haveGround() throws Exception {
        int side = 150;
        float[] corners = new float[side * side * 3];
        for (int i = 0; i < side * side; i++) {
            corners[3 * i] = i % side;
            corners[3 * i + 2] = i / side;
        }
        int[] indices = new int[(side - 1) * (side - 1) * 3];
        for (int i = 0; i < indices.length / 3; i++) {
            int corner = i / (side - 1) * side + i % (side - 1);
            indices[3 * i] = corner;
            indices[3 * i + 1] = corner + side;
            indices[3 * i + 2] = corner + 1;
        }
        new Model("ground", new ModelFiles(corners, indices, 0, 0, 0).put(project, ".glb"));
    }

    private void holdsNoMore(Callable<?> work) throws Exception {
        work.call();
        long before = held(0);
        for (int i = 0; i < STARTS; i++) {
            work.call();
        }
        long after = held(before + MEGABYTE);
        assertTrue(before + " bytes became " + after + " in " + STARTS + " times", after < before + MEGABYTE);
    }

    @Test
    public void manyStartsHoldNoMoreDirectMemoryThanOne() throws Exception {
        haveGround();
        holdsNoMore(() -> {
            start();
            return null;
        });
    }

    /** The tab rebuilds the world after each change of a file. */
    @Test
    public void manyPreviewsHoldNoMoreDirectMemoryThanOne() throws Exception {
        haveGround();
        Preview preview = new Preview();
        AtomicInteger changes = new AtomicInteger();
        holdsNoMore(() -> {
            String edge = "1." + changes.incrementAndGet();
            project.put("environment/box.xml", "<Box><name>box</name><length>" + edge
                + "</length><width>1</width><height>1</height></Box>");
            Map<String, Object> answer = preview.of(project.folder(), "");
            assertTrue(answer.toString(), answer.get("world") != null && Json.write(answer.get("world"))
                .contains("\"box\""));
            return answer;
        });
    }

    private void start() throws Exception {
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            assertEquals(0, world.snapshot().step);
        }
    }
}
