package org.myrobotlab.service;

import java.util.Arrays;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.Python3Config;
import org.myrobotlab.service.sear.lockstep.CallbackService;
import org.myrobotlab.service.sear.lockstep.FencePass;

/**
 * Stands in MyRobotLab for a Python 3 program that is connected to it or has it in its process: what is published to this service calls a function of
 * the program. The package {@code sear} for Python 3 starts it. Any thread.
 */
public class Python3 extends Service<Python3Config> implements CallbackService {
    private static final long serialVersionUID = 1L;

    /** So long after its last question a program is taken for ended, ns. */
    private static final long GONE = TimeUnit.SECONDS.toNanos(10);

    private final transient BlockingQueue<Message> calls = new LinkedBlockingQueue<>();
    private transient volatile long asked = System.nanoTime();
    /** Whether the program carries out a function. */
    private transient volatile boolean busy;
    private transient volatile Thread taker;
    private transient boolean told;

    /** As MyRobotLab makes services. */
    public Python3(String name, String id) {
        super(name, id);
    }

    /** Messages for this service are its own business; all others are for functions of the program. */
    @Override
    public boolean preProcessHook(Message message) {
        if (Arrays.stream(getClass().getMethods()).anyMatch(one -> one.getName().equals(message.method))) {
            return super.preProcessHook(message);
        }
        if (busy || System.nanoTime() - asked < GONE) {
            calls.add(message);
        } else if (!pass(message) && !told) {
            told = true;
            warn("the Python 3 program of %s has ended: nobody calls %s any more", getName(), message.method);
        }
        return false;
    }

    /** Whether lock-step has sent it, to hear when all before it is done. */
    private static boolean pass(Message message) {
        boolean is = message.data != null && message.data.length == 1 && message.data[0] instanceof FencePass;
        if (is) {
            FencePass.passed((FencePass) message.data[0]);
        }
        return is;
    }

    /**
     * For the program: the next function to call. The former one has ended.
     *
     * @param millis how long to wait for it
     * @return who calls ({@code ping.publishReading}), the function's name, its arguments; null if nobody does
     */
    public Object[] take(long millis) throws InterruptedException {
        taker = Thread.currentThread();
        busy = false;
        asked = System.nanoTime();
        Message message = calls.poll(millis, TimeUnit.MILLISECONDS);
        if (message == null || pass(message)) {
            return null;
        }
        busy = true;
        return new Object[] {CodecUtils.getShortName(message.sender) + "." + message.sendingMethod, message.method,
            message.data == null ? new Object[0] : message.data};
    }

    /** The thread of Java on which functions of the program call back. */
    @Override
    public Thread getCallbackThread() {
        return taker;
    }
}
