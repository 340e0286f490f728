// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Floor;
import org.SEAR.devices.SerialLine;
import org.SEAR.project.ProjectRule;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** The simulation thread: pace, pause, queries, steps on request, end. */
public class RunnerTest {
    @Rule
    public final ProjectRule project = new ProjectRule();
    private SimulationRunner runner;
    private Thread thread;

    @Before
    public void start() throws Exception {
        new Floor("floor", 10, 10);
        Arduino board = new Arduino("uno");
        board.setPorts("uart", "user");
        Worlds.roomba("roomba", 0, 0, 0).addComponent(board);
        runner = new SimulationRunner(Worlds.start(project));
        thread = new Thread(runner, "simulation under test");
    }

    @After
    public void end() throws InterruptedException {
        runner.stop();
        thread.join(60_000);
        assertFalse(thread.isAlive());
    }

    @Test(timeout = 120_000)
    public void pausedItAdvancesByTheStepsAskedForOnly() throws Exception {
        AtomicInteger heard = new AtomicInteger();
        runner.addStepListener(heard::incrementAndGet);
        runner.setPaused(true);
        thread.start();
        runner.setSpeed(Double.POSITIVE_INFINITY);
        runner.advance(120);
        assertEquals(120, runner.getSimulation().snapshot().step);
        assertEquals(2, runner.getSimulation().ask(Simulation::getTime).get(60, TimeUnit.SECONDS), 1e-9);
        assertEquals(120, heard.get());
        runner.advance(1);
        assertEquals(121, runner.getSimulation().snapshot().step);
    }

    @Test(timeout = 120_000)
    public void whileItIsPausedMrlCommAnswersBytesThatCome() throws Exception {
        SerialLine line = runner.getSimulation().getLines().get(0);
        BlockingQueue<Byte> heard = new LinkedBlockingQueue<>();
        line.setSink((bytes, starts) -> {
            for (byte each : bytes) {
                heard.add(each);
            }
        });
        runner.setPaused(true);
        thread.start();
        for (int i = 0; i < 100; i++) {
            line.write(Bytes.bytes("AA 03 1B 0D 01"));
            for (int value : Bytes.ints("AA 02 09 1B")) {
                assertEquals(value, heard.take() & 0xFF);
            }
        }
        assertEquals(0, runner.getSimulation().snapshot().step);
    }

    @Test(timeout = 120_000)
    public void aFailedCommandBecomesAWarningAndTheRunContinues() throws Exception {
        thread.start();
        runner.getSimulation().post(world -> {
            throw new IllegalStateException("no such thing");
        });
        runner.sleep(0.1);
        assertTrue(runner.getSimulation().snapshot().warnings.toString().contains("no such thing"));
        Future<Object> answer = runner.getSimulation().ask(world -> world.read("nobody"));
        try {
            answer.get(60, TimeUnit.SECONDS);
            assertTrue("an unknown sensor answered", false);
        } catch (ExecutionException e) {
            assertTrue(e.getMessage().contains("nobody"));
        }
    }

    @Test(timeout = 120_000)
    public void afterTheEndQueriesFailWithoutWaiting() throws Exception {
        runner.setPaused(true);
        thread.start();
        runner.advance(1);
        runner.stop();
        runner.sleep(100);
        try {
            runner.getSimulation().ask(Simulation::getTime).get(60, TimeUnit.SECONDS);
            assertTrue("an ended simulation answered", false);
        } catch (ExecutionException e) {
            assertTrue(e.getMessage().contains("ended"));
        }
    }
}
