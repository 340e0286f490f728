// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;

import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.myrobotlab.framework.Message;

/** When a Python 3 program counts as ended. */
public class Python3ServiceTest {
    private Python3 service;
    private long now;

    @Before
    public void start() {
        service = (Python3) Runtime.start("python3test", "Python3");
        service.clock = () -> now;
    }

    @After
    public void release() {
        Runtime.releaseService("python3test");
    }

    private void call(int number) {
        Message message = Message.createMessage("publisher", "python3test", "onReading", number);
        message.sendingMethod = "publishReading";
        service.preProcessHook(message);
    }

    private void pass(long seconds) {
        now += TimeUnit.SECONDS.toNanos(seconds);
    }

    @Test
    public void aProgramThatComputesForLongMissesNoCall() throws Exception {
        assertNull(service.take(0));
        pass(3600);
        call(1);
        pass(9);
        call(2);
        assertEquals(1, ((Object[]) service.take(0)[2])[0]);
        pass(3600);
        call(3);
        assertEquals(2, ((Object[]) service.take(0)[2])[0]);
        assertEquals(3, ((Object[]) service.take(0)[2])[0]);
        assertNull(service.take(0));
    }

    @Test
    public void aProgramThatLeavesACallWaitingHasEnded() throws Exception {
        assertNull(service.take(0));
        call(1);
        pass(11);
        call(2);
        assertEquals(1, ((Object[]) service.take(0)[2])[0]);
        assertNull("dropped", service.take(0));
    }
}
