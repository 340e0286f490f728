// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.util.Arrays;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.Python3Config;
import org.myrobotlab.service.sear.lockstep.CallbackService;
import org.myrobotlab.service.sear.lockstep.FencePass;

/**
 * MyRobotLab's stand-in for a Python 3 program that is connected to it or has it in its process. A message published to
 * this service calls a function of the program. The package {@code sear} for Python 3 starts it. Any thread.
 */
public class Python3 extends Service<Python3Config> implements CallbackService {
    private static final long serialVersionUID = 1L;

    /** Ends the wait of {@link #take}. */
    private static final Message WAKE_UP = new Message();
    /**
     * Time for which a call waits for the program's next request until the program counts as ended, ns. A program that
     * computes for long requests late, so the time starts with the call.
     */
    private static final long GONE = TimeUnit.SECONDS.toNanos(10);

    private final transient BlockingQueue<Message> calls = new LinkedBlockingQueue<>();
    /** Nanoseconds; tests replace it. */
    transient LongSupplier clock = System::nanoTime;
    /** Start of the first call's wait, or of the last request, ns. */
    private transient volatile long waiting;
    /** Whether the program is running a function. */
    private transient volatile boolean busy;
    private transient volatile Thread taker;
    private transient boolean told;

    /** Called by MyRobotLab. */
    public Python3(String name, String id) {
        super(name, id);
    }

    /** Handles messages for this service's own methods; queues all others for functions of the program. */
    @Override
    public boolean preProcessHook(Message message) {
        if (Arrays.stream(getClass().getMethods()).anyMatch(one -> one.getName().equals(message.method))) {
            return super.preProcessHook(message);
        }
        if (calls.isEmpty()) {
            waiting = clock.getAsLong();
        }
        if (busy || calls.isEmpty() || clock.getAsLong() - waiting < GONE) {
            calls.add(message);
        } else if (!pass(message) && !told) {
            told = true;
            warn("the Python 3 program of %s has ended and ignores calls of %s", getName(), message.method);
        }
        return false;
    }

    /**
     * Acknowledges a lock-step fence, which shows that all earlier messages are done; returns whether the message was
     * one.
     */
    private static boolean pass(Message message) {
        boolean is = message.data != null && message.data.length == 1 && message.data[0] instanceof FencePass;
        if (is) {
            FencePass.passed((FencePass) message.data[0]);
        }
        return is;
    }

    /**
     * Returns the next function for the program to call. The previous one has ended.
     *
     * @param millis how long to wait, milliseconds
     * @return the publisher ({@code ping.publishReading}), the function's name, its arguments; null after the timeout
     */
    public Object[] take(long millis) throws InterruptedException {
        taker = Thread.currentThread();
        busy = false;
        waiting = clock.getAsLong();
        Message message = calls.poll(millis, TimeUnit.MILLISECONDS);
        if (message == null || message == WAKE_UP || pass(message)) {
            return null;
        }
        busy = true;
        return new Object[] {CodecUtils.getShortName(message.sender) + "." + message.sendingMethod, message.method,
            message.data == null ? new Object[0] : message.data};
    }

    /** Ends a wait of {@link #take} without a function to call, for the end of the program. */
    public void wakeUp() {
        calls.add(WAKE_UP);
    }

    /** Returns the Java thread on which the program's functions call back. */
    @Override
    public Thread getCallbackThread() {
        return taker;
    }
}
