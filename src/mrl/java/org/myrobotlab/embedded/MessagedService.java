// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.List;
import java.util.Map;
import java.util.Timer;
import java.util.concurrent.atomic.AtomicLong;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.framework.Inbox;
import org.myrobotlab.framework.MRLListener;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Outbox;
import org.myrobotlab.framework.TimeoutException;
import org.myrobotlab.framework.interfaces.Broadcaster;
import org.myrobotlab.framework.interfaces.FutureInvoker;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.Runtime;
import org.slf4j.Logger;

/** Messages to and from a service, calls by name, and timed calls. */
public abstract class MessagedService extends PublishingService implements Broadcaster, FutureInvoker {
    private static final Logger LOG = LoggerFactory.getLogger(MessagedService.class);
    private static final AtomicLong FUTURES = new AtomicLong();
    private static final int DEFAULT_TIMEOUT_MS = 3000;
    private static final String DEFAULT_METHOD = "defaultInvokeMethod";

    protected final transient Inbox inbox;
    private final transient Tasks tasks = new Tasks(this);

    protected MessagedService(String name, String id) {
        super(name, id);
        inbox = new Inbox(getName());
    }

    /** Executes a message. */
    protected void process(Message msg) {
        if (preRoutingHook(msg) && preProcessHook(msg)) {
            invoke(msg);
        }
    }

    /**
     * Called first for each message.
     *
     * @return false if the hook has handled the message. An exception ends the service's thread.
     */
    public boolean preRoutingHook(Message msg) {
        return true;
    }

    /**
     * Called before each message is executed.
     *
     * @return false if the hook has handled the message. An exception ends the service's thread.
     */
    public boolean preProcessHook(Message msg) {
        return true;
    }

    public Message getMsg() throws InterruptedException {
        return inbox.getMsg();
    }

    @Override
    public void in(Message msg) {
        inbox.add(msg);
    }

    @Override
    public void out(Message msg) {
        outbox.add(msg);
    }

    @Override
    public void out(String method, Object data) {
        Message msg = Message.createMessage(getFullName(), null, method, data);
        msg.sendingMethod = method;
        outbox.add(msg);
    }

    @Override
    public Inbox getInbox() {
        return inbox;
    }

    @Override
    public Outbox getOutbox() {
        return outbox;
    }

    @Override
    public final Object invoke(Message msg) {
        return invokeOn(false, this, msg.method, msg.data == null ? new Object[0] : msg.data);
    }

    @Override
    public final Object invoke(String method) {
        return invokeOn(false, this, method);
    }

    @Override
    public final Object invoke(String method, Object... params) {
        return invokeOn(false, this, method, params);
    }

    @Override
    public final Object broadcast(String method) {
        return invokeOn(true, this, method);
    }

    @Override
    public final Object broadcast(String method, Object... params) {
        return invokeOn(true, this, method, params);
    }

    /** Calls a method of another service in this process. */
    public final Object invokeOn(String serviceName, String method, Object... params) {
        return invokeOn(false, Runtime.getService(serviceName), method, params);
    }

    @Override
    public final Object invokeOn(boolean blockLocally, Object obj, String methodName, Object... params) {
        if (obj == null) {
            failCall("%s can't be called: there is no such service", methodName);
            return null;
        }
        Object[] args = params == null ? new Object[] {null} : params;
        Method method = Methods.find(obj.getClass(), methodName, args);
        if (method == null) {
            failCall("%s has no method %s(%s)", obj, methodName, CodecUtils.getParameterSignature(args));
            return null;
        }
        try {
            Object answer = Methods.call(obj, method, args);
            if (blockLocally) {
                callListeners(obj, methodName, answer);
            } else {
                out(methodName, answer);
            }
            return answer;
        } catch (InvocationTargetException e) {
            failed(methodName, params, e.getCause());
            return null;
        }
    }

    /**
     * Reports a failed call. The status text is that of the real MyRobotLab: the arguments as Java prints an array, the
     * exception by its {@code toString}. The log gets a readable reason, unless the service has just logged that reason
     * itself.
     */
    private void failed(String methodName, Object[] params, Throwable cause) {
        if (cause instanceof InterruptedException) {
            Thread.currentThread().interrupt();
        } else {
            LOG.debug("{}.{}", getName(), methodName, cause);
            complain("could not invoke " + getName() + "." + methodName + " (" + params + ") " + cause
                + " - check logs for details",
                methodName, cause.getMessage() == null ? cause.toString() : cause.getMessage());
        }
    }

    /**
     * Publishes that a call has failed.
     *
     * @param text of the status
     * @param reason for the log, which puts the method before it
     */
    abstract void complain(String text, String method, String reason);

    /**
     * Calls the listeners on this thread and does not publish their results. A receiver without the method gets a call
     * of its default method.
     */
    private void callListeners(Object from, String method, Object answer) {
        Outbox box = from instanceof PublishingService ? ((PublishingService) from).outbox : outbox;
        for (MRLListener listener : box.getNotifyList().getOrDefault(method, List.of())) {
            ServiceInterface receiver = Runtime.getService(listener.callbackName);
            if (receiver == null) {
                LOG.debug("{}: no service {} to call back", getName(), listener.callbackName);
                continue;
            }
            try {
                callBack(receiver, listener.callbackMethod, answer);
            } catch (InvocationTargetException e) {
                LOG.error("{}: {}.{} failed", getName(), listener.callbackName, listener.callbackMethod, e.getCause());
            }
        }
    }

    private void callBack(ServiceInterface receiver, String name, Object answer) throws InvocationTargetException {
        Method method = Methods.find(receiver.getClass(), name, answer);
        Method instead = Methods.find(receiver.getClass(), DEFAULT_METHOD, name, new Object[] {answer});
        if (method != null) {
            Methods.call(receiver, method, answer);
        } else if (instead != null) {
            Methods.call(receiver, instead, name, new Object[] {answer});
        } else {
            LOG.warn("{}: {} has no method {}", getName(), receiver.getName(), name);
        }
    }

    @Override
    public final void invokeFuture(String method, long delayMs) {
        invokeFuture(method, delayMs, new Object[0]);
    }

    @Override
    public final void invokeFuture(String method, long delayMs, Object... params) {
        addTask(method + "-" + FUTURES.incrementAndGet(), true, 0, delayMs, method, params);
    }

    @Override
    public void send(Message msg) {
        outbox.add(msg);
    }

    @Override
    public void send(String receiver, String method) {
        send(receiver, method, new Object[0]);
    }

    /**
     * Calls another service of this process immediately on this thread, ahead of queued messages, and then its
     * listeners. {@code send(Message)} queues instead.
     */
    @Override
    public void send(String receiver, String method, Object... data) {
        ServiceInterface service = Runtime.getService(receiver);
        if (service == null) {
            LOG.info("{}: no service {} to take {}", getName(), receiver, method);
        } else {
            invokeOn(true, service, method, data);
        }
    }

    @Override
    public Object sendBlocking(String receiver, String method) throws InterruptedException, TimeoutException {
        return sendBlocking(receiver, method, new Object[0]);
    }

    @Override
    public Object sendBlocking(String receiver, String method, Object... data)
        throws InterruptedException, TimeoutException {
        return sendBlocking(receiver, DEFAULT_TIMEOUT_MS, method, data);
    }

    @Override
    public Object sendBlocking(String receiver, Integer timeout, String method, Object... data)
        throws InterruptedException, TimeoutException {
        return sendBlocking(Message.createMessage(getFullName(), receiver, method, data), timeout);
    }

    /**
     * Calls another service of this process immediately on this thread, ahead of queued messages. The listeners get the
     * result as usual.
     */
    @Override
    public Object sendBlocking(Message msg, Integer timeout) throws InterruptedException, TimeoutException {
        ServiceInterface service = Runtime.getService(msg.name);
        if (service == null) {
            failCall("cannot get service %s", msg.name);
            return null;
        }
        return service.invoke(msg);
    }

    @Override
    public void addTask(long intervalMs, String method) {
        addTask(intervalMs, method, new Object[0]);
    }

    @Override
    public void addTask(long intervalMs, String method, Object... params) {
        addTask(method, intervalMs, 0, method, params);
    }

    @Override
    public synchronized void addTask(String taskName, long intervalMs, long delayMs, String method, Object... params) {
        addTask(taskName, false, intervalMs, delayMs, method, params);
    }

    @Override
    public synchronized void addTask(String taskName, boolean oneShot, long intervalMs, long delayMs, String method,
        Object... params) {
        tasks.add(taskName, oneShot, intervalMs, delayMs, method, params);
    }

    @Override
    public void addTaskOneShot(long delayMs, String method, Object... params) {
        addTask(method, true, 0, delayMs, method, params);
    }

    @Override
    public boolean containsTask(String taskName) {
        return tasks.timers().containsKey(taskName);
    }

    @Override
    public Map<String, Timer> getTasks() {
        return tasks.timers();
    }

    @Override
    public synchronized void purgeTask(String taskName) {
        tasks.purge(taskName);
    }

    @Override
    public void purgeTasks() {
        tasks.purgeAll();
    }
}
