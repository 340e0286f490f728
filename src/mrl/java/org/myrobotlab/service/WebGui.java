// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.IOException;
import java.util.Set;
import org.myrobotlab.embedded.web.Address;
import org.myrobotlab.embedded.web.Hub;
import org.myrobotlab.embedded.web.WebServer;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Registration;
import org.myrobotlab.framework.Service;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.config.WebGuiConfig;
import org.myrobotlab.service.interfaces.ServiceLifeCycleListener;
import org.slf4j.Logger;

/**
 * Shows services in a browser, a tab for each. Only this computer can connect, unless the program was started
 * otherwise.
 */
public class WebGui extends Service<WebGuiConfig> implements ServiceLifeCycleListener {
    public static final Logger log = LoggerFactory.getLogger(WebGui.class);

    private static final long serialVersionUID = 1L;
    private static final Set<String> LIFE = Set.of("created", "registered", "started", "stopped", "released");

    private final transient Hub hub;
    private transient WebServer server;

    public WebGui(String name, String id) {
        super(name, id);
        hub = new Hub(getName());
    }

    @Override
    public synchronized void startService() {
        super.startService();
        Runtime.getInstance().attachServiceLifeCycleListener(getName());
        start();
    }

    /** Starts the server, unless it is running. */
    public synchronized void start() {
        if (server == null) {
            try {
                server = new WebServer(config.port, config.resources, hub);
                info("tabs at %s", Address.current().url(config.port));
            } catch (IOException e) {
                error(e.getMessage());
            }
        }
    }

    /** Stops the server. */
    public synchronized void stop() {
        if (server != null) {
            server.stop();
            server = null;
        }
    }

    /** Stops the server and starts it again, for example on another port. */
    public void restart() {
        stop();
        start();
    }

    /** Returns whether the server is running. */
    public synchronized boolean isStarted() {
        return server != null;
    }

    @Override
    public synchronized void stopService() {
        stop();
        super.stopService();
    }

    public Integer getPort() {
        return config.port;
    }

    /** Sets the port from the next start on. */
    public void setPort(Integer newPort) {
        config.port = newPort;
    }

    /** Passes messages of other services to the pages that listen. */
    @Override
    public boolean preProcessHook(Message msg) {
        if (msg.sendingMethod == null || msg.sendingMethod.isEmpty()) {
            return true;
        }
        try {
            hub.forward(msg);
        } catch (IllegalArgumentException e) {
            log.warn("{}.{} can't be shown: {}", msg.sender, msg.sendingMethod, e.getMessage());
        }
        return LIFE.contains(msg.sendingMethod) && Runtime.getInstance().getFullName().equals(msg.sender);
    }

    @Override
    public void onCreated(String name) {
        log.debug("{} was created", name);
    }

    @Override
    public void onRegistered(Registration registration) {
        log.debug("{} is registered", registration);
    }

    @Override
    public void onStarted(String name) {
        hub.reportServices();
    }

    @Override
    public void onStopped(String name) {
        hub.reportServices();
    }

    @Override
    public void onReleased(String name) {
        hub.reportServices();
    }
}
