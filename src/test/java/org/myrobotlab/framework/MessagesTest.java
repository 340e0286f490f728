// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.service.Runtime;

/** Messages between services of the embedded MyRobotLab. */
public class MessagesTest {
    private Talker a;
    private Talker b;

    @Before
    public void start() {
        a = (Talker) Runtime.start("a", Talker.class.getName());
        b = (Talker) Runtime.start("b", Talker.class.getName());
    }

    @After
    public void release() {
        Runtime.releaseAll();
    }

    @Test
    public void resultsOfAMethodReachItsListenersInOrder() throws InterruptedException {
        b.subscribe("a", "publishNumber");
        for (int i = 0; i < 1000; i++) {
            a.invoke("publishNumber", i);
        }
        for (int i = 0; i < 1000; i++) {
            assertEquals(i, b.next());
        }
    }

    @Test
    public void callbacksAreNamedAfterTheTopic() {
        assertEquals("onNumber", CodecUtils.getCallbackTopicName("publishNumber"));
        assertEquals("onNumber", CodecUtils.getCallbackTopicName("getNumber"));
        assertEquals("onStarted", CodecUtils.getCallbackTopicName("started"));
    }

    @Test
    public void aListenerChoosesItsMethodAndListensOnceOnly() throws InterruptedException {
        a.addListener("publishNumber", "b", "other");
        a.addListener("publishNumber", "b", "other");
        a.addListener("publishNumber", "b");
        a.invoke("publishNumber", 7);
        assertEquals("other 7", b.next());
        assertEquals(7, b.next());
        a.removeListener("publishNumber", "b");
        a.removeListener("publishNumber", "b@embedded", "other");
        a.invoke("publishNumber", 8);
        a.send("b", "other", 9);
        assertEquals("other 9", b.next());
    }

    @Test
    public void anArrayIsOneArgumentAndVoidHasNone() throws InterruptedException {
        b.subscribe("a", "publishArray");
        b.subscribe("a", "publishNothing");
        a.invoke("publishArray", (Object) new int[] {1, 2});
        a.invoke("publishNothing");
        assertArrayEquals(new int[] {1, 2}, (int[]) b.next());
        assertEquals("nothing", b.next());
    }

    @Test
    public void messagesRunOnTheReceiversThreadAndCallsOnTheCallers() throws Exception {
        String here = Thread.currentThread().getName();
        b.addListener("whoCalls", "b", "onCaller");
        b.in(Message.createMessage("a", "b", "whoCalls", new Object[0]));
        assertEquals("b", b.next());
        assertEquals(here, b.invoke("whoCalls"));
        assertEquals(here, b.next());
        assertEquals(here, a.sendBlocking("b", "whoCalls"));
        assertEquals("its listeners are told", here, b.next());
    }

    @Test
    public void sendCallsImmediatelyAndDropsTheResult() {
        a.addListener("publishNumber", "b", "publishNumber");
        a.addListener("publishNumber", "a", "onNumber");
        b.addListener("publishNumber", "a", "onNumber");
        b.send("a", "publishNumber", 4);
        assertEquals(4, a.heard.poll());
        b.invokeOn("a", "publishNumber", 5);
        assertEquals("who calls publishes, not who is called", 5, nextOf(a));
        assertNull(a.heard.poll());
    }

    private static Object nextOf(Talker talker) {
        try {
            return talker.next();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    public void numbersWidenToTheParameterType() throws Exception {
        assertEquals(1.5, a.sendBlocking("b", "half", 3));
        assertEquals(1.5, b.invoke("half", 3L));
    }

    @Test
    public void aBlockingCallToAMissingServiceIsAnError() throws Exception {
        assertNull(a.sendBlocking("nobody", 50, "half", 1.0));
        assertEquals("cannot get service nobody", a.getLastError().key);
    }

    @Test
    public void broadcastCallsListenersBeforeItReturns() {
        b.subscribe("a", "publishNumber");
        a.broadcast("publishNumber", 5);
        assertEquals(Integer.valueOf(5), b.heard.poll());
    }

    @Test
    public void statusesAndStatesArePublished() throws InterruptedException {
        b.subscribe("a", "publishStatus");
        b.subscribe("a", "publishState");
        a.broadcastStatus(Status.warn("%d %% of %s", 10, "power"));
        Status status = (Status) b.next();
        assertTrue(status.isWarn());
        assertEquals("a", status.name);
        assertEquals("10 % of power", status.detail);
        a.broadcastState();
        assertEquals("state of a", b.next());
        assertFalse(a.hasError());
        a.error("100% wrong");
        assertEquals("100% wrong", ((Status) b.next()).key);
        assertEquals("100% wrong", a.getLastError().key);
        assertEquals("a error 100% wrong", a.clearLastError());
        assertFalse(a.hasError());
    }

    @Test
    public void warningsOfAServiceAreErrors() throws InterruptedException {
        b.subscribe("a", "publishStatus");
        assertTrue(Status.warn("low").isError());
        a.warn("low");
        assertTrue(((Status) b.next()).isError());
        a.warn("%d %%", 10);
        Status status = (Status) b.next();
        assertTrue(status.isError());
        assertEquals("10 %", status.detail);
    }

    @Test
    public void anExceptionOfAMethodBecomesAnErrorAndTheServiceContinues() throws InterruptedException {
        b.subscribe("a", "publishError", "onStatus");
        a.in(Message.createMessage("b", "a", "fail", new Object[0]));
        String error = ((Status) b.next()).key;
        assertTrue(error, error.matches("could not invoke a\\.fail \\(\\[Ljava\\.lang\\.Object;@[0-9a-f]+\\) .*: no "
            + "good - check logs for details"));
        a.in(Message.createMessage("b", "a", "nix", new Object[] {1, "two"}));
        assertEquals("a has no method nix(Integer, String)", ((Status) b.next()).key);
        a.in(Message.createMessage("b", "a", "tick", new Object[0]));
        assertEquals("tick", a.next());
    }

    @Test
    public void anExceptionFromAMessageHookEndsTheThread() throws InterruptedException {
        b.subscribe("a", "publishError", "onStatus");
        Thread thread = a.getThisThread();
        a.failInHook(true);
        a.in(Message.createMessage("b", "a", "tick", new Object[0]));
        assertEquals("IllegalStateException: hook", ((Status) b.next()).key);
        thread.join(TimeUnit.SECONDS.toMillis(60));
        assertFalse(thread.isAlive());
    }

    @Test
    public void tasksRepeatUntilTheyArePurged() throws InterruptedException {
        a.addTask(5, "tick");
        assertEquals("tick", a.next());
        assertEquals("tick", a.next());
        assertTrue(a.containsTask("tick"));
        a.purgeTask("tick");
        assertFalse(a.containsTask("tick"));
        b.addTaskOneShot(1, "onNumber", 3);
        assertEquals(3, b.next());
        b.invokeFuture("onNumber", 1, 4);
        assertEquals(4, b.next());
    }

    @Test
    public void aReleasedListenerReceivesAgainAfterARestart() throws InterruptedException {
        b.subscribe("a", "publishNumber");
        Runtime.release("b");
        assertTrue(a.hasSubscribed("b", "publishNumber"));
        assertNull(Runtime.getService("b"));
        a.invoke("publishNumber", 1);
        Talker again = (Talker) Runtime.start("b", Talker.class.getName());
        assertNotEquals(b, again);
        a.invoke("publishNumber", 2);
        while (!Integer.valueOf(2).equals(again.next())) { // the outbox may still have contained 1
            assertTrue(a.hasSubscribed("b", "publishNumber"));
        }
    }
}
