package org.myrobotlab.service.config;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.myrobotlab.framework.Peer;
import org.myrobotlab.framework.Plan;
import org.myrobotlab.logging.LoggerFactory;
import org.slf4j.Logger;

/** What a service keeps from one start to the next. */
public class ServiceConfig {
    public static final Logger log = LoggerFactory.getLogger(ServiceConfig.class);

    private static final String PACKAGE = "org.myrobotlab.service.config.";

    /** Type of the service, without package. */
    public String type;
    /** Services that belong to this one. */
    public Map<String, Peer> peers;
    /** Who listens. */
    public List<Listener> listeners;

    public ServiceConfig() {
        String simple = getClass().getSimpleName();
        type = simple.endsWith("Config") ? simple.substring(0, simple.length() - "Config".length()) : simple;
    }

    /** Adds this configuration, and those of the services that belong to this one, to a plan. */
    public Plan getDefault(Plan plan, String name) {
        plan.put(name, this);
        return plan;
    }

    /** Adds the configuration of a type to a plan. */
    public static Plan getDefault(Plan plan, String name, String serviceType) {
        return getDefaultServiceConfig(serviceType).getDefault(plan, name);
    }

    /** The configuration of a type as it is without any file. */
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

    /** Class name of the configuration of a type. */
    public static String getConfigType(String serviceType) {
        return PACKAGE + serviceType.substring(serviceType.lastIndexOf('.') + 1) + "Config";
    }

    public Map<String, Peer> getPeers() {
        return peers;
    }

    public Peer getPeer(String key) {
        return peers == null ? null : peers.get(key);
    }

    /** Name in the registry of a service that belongs to this one; null if there is none of that key. */
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

    /** Gives this service one of its own, named {@code name.key}. */
    public ServiceConfig addDefaultPeerConfig(Plan plan, String name, String key, String peerType, boolean autoStart) {
        return addDefaultGlobalConfig(plan, key, name + "." + key, peerType, autoStart);
    }

    public ServiceConfig addDefaultGlobalConfig(Plan plan, String key, String globalName, String peerType) {
        return addDefaultGlobalConfig(plan, key, globalName, peerType, true);
    }

    /** Gives this service one of its own, of any name. */
    public ServiceConfig addDefaultGlobalConfig(Plan plan, String key, String globalName, String peerType, boolean autoStart) {
        putPeerType(key, globalName, peerType);
        peers.get(key).autoStart = autoStart;
        getDefault(plan, globalName, peerType);
        return plan.get(globalName);
    }

    /** Someone who listens, as written in a file. */
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
                && Objects.equals(listener, ((Listener) other).listener) && Objects.equals(callback, ((Listener) other).callback);
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
