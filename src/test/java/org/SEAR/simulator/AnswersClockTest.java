// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.Slow;
import org.SEAR.devices.SerialLine;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Response time of a device by the clock, in steps of the simulation, which a busy machine delays equally. */
@Category(Slow.class)
public class AnswersClockTest {
    private static final int QUESTIONS = 300;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test(timeout = 120_000)
    public void aQuestionIsAnsweredBeforeTheNextStep() throws Exception {
        new Floor("floor", 10, 10);
        Robots.create2("rover", "uart", "user");
        SimulationRunner runner = new SimulationRunner(Worlds.start(project));
        SerialLine line = runner.getSimulation().getLines().get(0);
        BlockingQueue<Long> answers = new LinkedBlockingQueue<>();
        line.setSink((bytes, starts) -> answers.add(runner.getSimulation().snapshot().step));
        Thread thread = new Thread(runner, "simulation under test");
        thread.start();
        runner.sleep(0.1);
        line.write(Bytes.bytes("80"));
        int early = 0;
        double[] millis = new double[QUESTIONS];
        for (int i = 0; i < QUESTIONS; i++) {
            long step = runner.getSimulation().snapshot().step;
            long begin = System.nanoTime();
            line.write(Bytes.bytes("8E 23"));
            early += answers.take() == step ? 1 : 0;
            millis[i] = (System.nanoTime() - begin) / 1e6;
        }
        runner.stop();
        thread.join();
        Arrays.sort(millis);
        System.out.printf("answers after %.2f ms in the median, %.1f ms for 99 of 100; %d of %d in the step of "
            + "their question%n", millis[QUESTIONS / 2], millis[QUESTIONS * 99 / 100], early, QUESTIONS);
        assertTrue(early + " of " + QUESTIONS, early > QUESTIONS / 10);
        assertEquals(0, answers.size());
    }
}
