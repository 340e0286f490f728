// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.io.IOException;
import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.embedded.ReportingService;
import org.myrobotlab.framework.interfaces.ConfigurableService;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.config.ServiceConfig;
import org.slf4j.Logger;

/**
 * A part of a robot, real or simulated. Executes messages one at a time on its own thread; any thread may call its
 * methods directly. Publishes the results of its methods. While it runs it has two threads, for its inbox and its
 * outbox.
 */
public abstract class Service<T extends ServiceConfig> extends ReportingService implements Runnable, Serializable,
    ConfigurableService<T> {
    public static final Logger log = LoggerFactory.getLogger(Service.class);

    private static final long serialVersionUID = 1L;
    private static final int JOIN_MS = 1000;

    @SuppressWarnings("serial")
    protected T config;
    protected transient Thread thisThread;
    protected boolean ready = true;
    private volatile boolean running;

    /**
     * @param name unique in this process
     * @param id of this process
     */
    @SuppressWarnings("unchecked")
    public Service(String name, String id) {
        super(name, id);
        config = (T) getDefault().get(getName());
    }

    /**
     * Starts the threads unless {@link #isRunning} returns true, as the real MyRobotLab does. A service that overrides
     * it wrongly fails here.
     *
     * @throws IllegalThreadStateException if the service runs but {@link #isRunning} returns false
     */
    @Override
    public synchronized void startService() {
        if (isRunning()) {
            return;
        }
        outbox.start();
        if (thisThread == null) {
            thisThread = new Thread(this, getName());
            thisThread.setDaemon(true);
        }
        running = true;
        thisThread.start();
        Runtime.getInstance().invoke("started", getFullName());
    }

    @Override
    public synchronized void stopService() {
        if (!running) {
            return;
        }
        running = false;
        purgeTasks();
        outbox.stop();
        Thread thread = thisThread;
        thisThread = null;
        if (thread != null) {
            thread.interrupt();
        }
        if (Runtime.exists()) {
            Runtime.getInstance().invoke("stopped", getFullName());
        }
    }

    @Override
    public synchronized void releaseService() {
        purgeTasks();
        releaseOwnPeers();
        Thread thread = thisThread;
        stopService();
        Runtime.unregister(getFullName());
        await(thread);
    }

    private void releaseOwnPeers() {
        for (String key : new ArrayList<>(getPeerKeys())) {
            ServiceInterface peer = getPeer(key);
            if (peer != null && getPeerName(key).startsWith(getName() + ".")) {
                peer.releaseService();
            }
        }
    }

    /** Gives the message in progress a moment to end. */
    private static void await(Thread thread) {
        if (thread == null || thread == Thread.currentThread()) {
            return;
        }
        try {
            thread.join(JOIN_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void preShutdown() {
        log.debug("{}: shutdown", getName());
    }

    @Override
    public boolean isRunning() {
        return running;
    }

    @Override
    public boolean isReady() {
        return ready;
    }

    protected void setReady(Boolean on) {
        ready = on;
    }

    public Thread getThisThread() {
        return thisThread;
    }

    /** Returns the stack trace as text. */
    public static String stackToString(Throwable e) {
        return Status.stackToString(e);
    }

    /** Waits by the computer's clock. */
    public static void sleep(int millis) {
        sleep((long) millis);
    }

    /** Waits by the computer's clock. */
    public static void sleep(long millis) {
        try {
            TimeUnit.MILLISECONDS.sleep(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Returns whether there is no display. */
    public static boolean isHeadless() {
        return java.awt.GraphicsEnvironment.isHeadless();
    }

    @Override
    public final void run() {
        Thread own = Thread.currentThread();
        try {
            while (running && thisThread == own) {
                process(getMsg());
            }
        } catch (InterruptedException e) {
            log.debug("{}: inbox closed", getName());
        } catch (RuntimeException e) {
            error(e);
        }
    }

    @Override
    public Service<?> broadcastState() {
        invoke("publishState");
        return this;
    }

    @Override
    public Service<T> publishState() {
        return this;
    }

    // ---- configuration
    // ------------------------------------------------------------------------------------------------

    /** Returns the default configurations of this service and its peers. */
    public final Plan getDefault() {
        return ServiceConfig.getDefault(new Plan(getName()), getName(), getTypeKey());
    }

    @Override
    public T getConfig() {
        return config;
    }

    /**
     * Applies a configuration and adds its listeners.
     *
     * @throws IllegalArgumentException if it is for another type of service
     */
    @Override
    public T apply(T newConfig) {
        if (newConfig == null || !config.getClass().isInstance(newConfig)) {
            throw new IllegalArgumentException("the configuration of " + getName() + " is a "
                + (newConfig == null ? null : newConfig.getClass().getSimpleName()) + ", legal: " + config.getClass()
                    .getSimpleName());
        }
        config = newConfig;
        addConfigListeners(newConfig);
        return newConfig;
    }

    /** Applies the current configuration again, after a field has changed. */
    public void apply() {
        apply(config);
    }

    /** Returns a copy of the configuration with the current listeners, as saved to a file. */
    @Override
    public ServiceConfig getFilteredConfig() {
        ServiceConfig copy = CodecUtils.fromYaml(CodecUtils.toYaml(getConfig()), config.getClass());
        List<ServiceConfig.Listener> listeners = new ArrayList<>();
        getNotifyList().forEach((topic, all) -> all.forEach(one -> listeners.add(
            new ServiceConfig.Listener(topic, CodecUtils.getShortName(one.callbackName), one.callbackMethod))));
        if (!listeners.isEmpty()) {
            copy.listeners = listeners;
        }
        return copy;
    }

    /** Adds the listeners of a configuration. */
    @Override
    public ServiceConfig addConfigListeners(ServiceConfig from) {
        if (from != null && from.listeners != null) {
            from.listeners.forEach(one -> addListener(one.method, one.listener, one.callback));
        }
        return from;
    }

    @Override
    public void setConfigValue(String fieldName, Object value) throws IllegalAccessException, NoSuchFieldException {
        config.getClass().getField(fieldName).set(config, value);
    }

    @Override
    public boolean save() {
        return Runtime.getInstance().saveService(Runtime.getInstance().getConfigName(), getName(), null);
    }

    @Override
    @SuppressWarnings("unchecked")
    public ServiceConfig load() throws IOException {
        ServiceConfig read = Runtime.getInstance().readServiceConfig(getName());
        return read == null ? null : apply((T) read);
    }

    // ---- services that belong to this one
    // -----------------------------------------------------------------------------

    @Override
    public Map<String, Peer> getPeers() {
        return config == null || config.getPeers() == null ? Map.of() : config.getPeers();
    }

    @Override
    public Set<String> getPeerKeys() {
        return new TreeSet<>(getPeers().keySet());
    }

    @Override
    public String getPeerKey(String peerName) {
        return getPeers().entrySet().stream()
            .filter(one -> CodecUtils.checkServiceNameEquality(one.getValue().name, peerName))
            .map(Map.Entry::getKey).findFirst().orElse(null);
    }

    /** Returns the peer's name in the registry; null if there is no such key. */
    public String getPeerName(String key) {
        return config == null ? null : config.getPeerName(key);
    }

    /** Returns a peer; null if it is not in the registry. */
    public ServiceInterface getPeer(String key) {
        String peerName = getPeerName(key);
        return peerName == null ? null : Runtime.getService(peerName);
    }

    public boolean isPeerStarted(String key) {
        ServiceInterface peer = getPeer(key);
        return peer != null && peer.isRunning();
    }

    @Override
    public synchronized ServiceInterface startPeer(String key) {
        Peer peer = getPeers().get(key);
        if (peer == null) {
            failCall("%s has no peer \"%s\"; its peers are %s", getName(), key, getPeerKeys());
            return null;
        }
        return Runtime.start(peer.name, peer.type);
    }

    @Override
    public synchronized void startPeers(String[] keys) {
        for (String key : keys) {
            startPeer(key);
        }
    }

    @Override
    public synchronized void releasePeer(String key) {
        ServiceInterface peer = getPeer(key);
        if (peer != null) {
            peer.releaseService();
        }
    }

    @Override
    public synchronized void releasePeers(String[] keys) {
        for (String key : keys) {
            releasePeer(key);
        }
    }

    // ---- folders
    // ------------------------------------------------------------------------------------------------------

    /** Returns the folder of panels, examples and icons, relative to the working folder. */
    public static String getResourceRoot() {
        return Resources.root();
    }

    /** Returns the folder of this type's resources. */
    public String getResourceDir() {
        return Resources.of(getSimpleName(), null);
    }

    public static String getResourceDir(Class<?> type) {
        return Resources.of(type.getSimpleName(), null);
    }

    public static String getResourceDir(Class<?> type, String file) {
        return Resources.of(type.getSimpleName(), file);
    }

    public String getResourcePath(String file) {
        return Resources.of(getSimpleName(), file);
    }

    /** Returns a file of this type's resources; null if there is no such file. */
    public byte[] getResource(String file) {
        return Resources.read(getSimpleName(), file);
    }

    public static byte[] getResource(Class<?> type, String file) {
        return Resources.read(type.getSimpleName(), file);
    }

    public String getResourceAsString(String file) {
        return getResourceAsString(getSimpleName(), file);
    }

    public static String getResourceAsString(Class<?> type, String file) {
        return getResourceAsString(type.getSimpleName(), file);
    }

    public static String getResourceAsString(String typeName, String file) {
        byte[] bytes = Resources.read(typeName, file);
        return bytes == null ? null : new String(bytes, StandardCharsets.UTF_8);
    }

    /** Returns the folder of this type's data. */
    public String getDataDir() {
        return getDataDir(getSimpleName());
    }

    public static String getDataDir(String typeName) {
        return Paths.get(Resources.data(), typeName).toString();
    }

    public String getRootDataDir() {
        return Resources.data();
    }
}
