// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.myrobotlab.framework.Peer;
import org.myrobotlab.framework.Plan;
import org.myrobotlab.logging.LoggerFactory;
import org.slf4j.Logger;

/** Saved settings of a service. */
public class ServiceConfig {
    public static final Logger log = LoggerFactory.getLogger(ServiceConfig.class);

    private static final String PACKAGE = "org.myrobotlab.service.config.";

    /** Type of the service, without its package. */
    public String type;
    /** Services that belong to this one, by key. */
    public Map<String, Peer> peers;
    /** Listeners of the service. */
    public List<Listener> listeners;

    public ServiceConfig() {
        String simple = getClass().getSimpleName();
        type = simple.endsWith("Config") ? simple.substring(0, simple.length() - "Config".length()) : simple;
    }

    /** Adds this configuration and those of the peers to a plan. */
    public Plan getDefault(Plan plan, String name) {
        plan.put(name, this);
        return plan;
    }

    /** Adds the configuration of a type to a plan. */
    public static Plan getDefault(Plan plan, String name, String serviceType) {
        return getDefaultServiceConfig(serviceType).getDefault(plan, name);
    }

    /** Returns the default configuration of a type. */
    public static ServiceConfig getDefaultServiceConfig(String serviceType) {
        String simple = serviceType.substring(serviceType.lastIndexOf('.') + 1);
        try {
            return (ServiceConfig) Class.forName(getConfigType(serviceType)).getConstructor().newInstance();
        } catch (ClassNotFoundException e) {
            ServiceConfig plain = new ServiceConfig();
            plain.type = simple;
            return plain;
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("the configuration of " + simple + " can't be made: " + e, e);
        }
    }

    /** Returns the class name of a type's configuration. */
    public static String getConfigType(String serviceType) {
        return PACKAGE + serviceType.substring(serviceType.lastIndexOf('.') + 1) + "Config";
    }

    public Map<String, Peer> getPeers() {
        return peers;
    }

    public Peer getPeer(String key) {
        return peers == null ? null : peers.get(key);
    }

    /** Returns a peer's name in the registry; null if there is no such key. */
    public String getPeerName(String key) {
        Peer peer = getPeer(key);
        return peer == null ? null : peer.name;
    }

    public Peer putPeerType(String key, String peerName, String peerType) {
        if (peers == null) {
            peers = new TreeMap<>();
        }
        return peers.put(key, new Peer(peerName, peerType));
    }

    public ServiceConfig addDefaultPeerConfig(Plan plan, String name, String key, String peerType) {
        return addDefaultPeerConfig(plan, name, key, peerType, true);
    }

    /** Adds a peer named {@code name.key}. */
    public ServiceConfig addDefaultPeerConfig(Plan plan, String name, String key, String peerType, boolean autoStart) {
        return addDefaultGlobalConfig(plan, key, name + "." + key, peerType, autoStart);
    }

    public ServiceConfig addDefaultGlobalConfig(Plan plan, String key, String globalName, String peerType) {
        return addDefaultGlobalConfig(plan, key, globalName, peerType, true);
    }

    /** Adds a peer of any name. */
    public ServiceConfig addDefaultGlobalConfig(Plan plan, String key, String globalName, String peerType,
        boolean autoStart) {
        putPeerType(key, globalName, peerType);
        peers.get(key).autoStart = autoStart;
        getDefault(plan, globalName, peerType);
        return plan.get(globalName);
    }

    /** A listener as saved in a file. */
    public static class Listener {
        public String method;
        public String listener;
        public String callback;

        public Listener() {
        }

        public Listener(String method, String listener) {
            this(method, listener, null);
        }

        public Listener(String method, String listener, String callback) {
            this.method = method;
            this.listener = listener;
            this.callback = callback;
        }

        @Override
        public boolean equals(Object other) {
            return other instanceof Listener && Objects.equals(method, ((Listener) other).method)
                && Objects.equals(listener, ((Listener) other).listener)
                && Objects.equals(callback, ((Listener) other).callback);
        }

        @Override
        public final int hashCode() {
            return Objects.hash(method, listener, callback);
        }

        @Override
        public String toString() {
            return method + " --> " + listener + "." + callback;
        }
    }
}
