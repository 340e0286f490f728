// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.myrobotlab.framework.Inbox;
import org.myrobotlab.framework.MRLListener;
import org.myrobotlab.framework.Outbox;
import org.myrobotlab.framework.Peer;
import org.myrobotlab.service.config.ServiceConfig;
import org.myrobotlab.service.meta.abstracts.MetaData;

/** Methods of every service. */
public interface ServiceInterface extends ServiceQueue, LoggingSink, NameTypeProvider, MessageSubscriber, MessageSender,
    StateSaver, Invoker, StatePublisher, StatusPublisher, ServiceStatus, TaskManager, Attachable, MessageInvoker,
    Comparable<ServiceInterface> {
    /** Starts the threads. */
    void startService();

    /** Stops the threads. */
    void stopService();

    /** Stops the service and removes it from the registry. */
    void releaseService();

    /** Called before everything is shut down. */
    void preShutdown();

    /** Whether the threads run. */
    boolean isRunning();

    /** Whether it can be used. */
    boolean isReady();

    /** Whether it is the Runtime. */
    boolean isRuntime();

    /** Whether it works without hardware. */
    boolean isVirtual();

    /** Sets whether it works without hardware. */
    boolean setVirtual(boolean virtual);

    /** Name with the process id: name@id. */
    String getFullName();

    /** Process id. */
    String getId();

    /** Full class name. */
    String getTypeKey();

    /** Position in the order of creation. */
    int getCreationOrder();

    /** Sets the position in the order of creation. */
    void setOrder(int order);

    /**
     * Purpose of the service.
     *
     * @throws RuntimeException if its type has no meta data
     */
    String getDescription();

    /** Meta data of its type. */
    MetaData getMetaData();

    /** Incoming messages. */
    Inbox getInbox();

    /** Outgoing messages. */
    Outbox getOutbox();

    /** All listeners by published method. */
    Map<String, List<MRLListener>> getNotifyList();

    /** The listeners of a published method. */
    List<MRLListener> getNotifyList(String key);

    /** The methods that have listeners. */
    List<String> getNotifyListKeySet();

    /** Current configuration. */
    ServiceConfig getConfig();

    /** Configuration as saved to a file. */
    ServiceConfig getFilteredConfig();

    /** Adds the listeners of a configuration. */
    ServiceConfig addConfigListeners(ServiceConfig config);

    /** Sets one field of the configuration. */
    void setConfigValue(String fieldName, Object value) throws IllegalAccessException, NoSuchFieldException;

    /** Peers: the services that belong to this one, by key. */
    Map<String, Peer> getPeers();

    /** Keys of the peers. */
    Set<String> getPeerKeys();

    /** Key of a peer. */
    String getPeerKey(String name);

    /** Starts a peer. */
    ServiceInterface startPeer(String key);

    /** Starts peers. */
    void startPeers(String[] keys);

    /** Releases a peer. */
    void releasePeer(String key);

    /** Releases peers. */
    void releasePeers(String[] keys);

    /** Publishes data as the named method. */
    void out(String method, Object data);

    /** Whether there was an error. */
    boolean hasError();

    /** Clears the last error and returns its text. */
    String clearLastError();

    /** Names of the public methods. */
    String[] getMethodNames();
}
