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

/** What every service can do. */
public interface ServiceInterface extends ServiceQueue, LoggingSink, NameTypeProvider, MessageSubscriber, MessageSender, StateSaver, Invoker,
    StatePublisher, StatusPublisher, ServiceStatus, TaskManager, Attachable, MessageInvoker, Comparable<ServiceInterface> {
    /** Starts its threads. */
    void startService();

    /** Stops its threads. */
    void stopService();

    /** Stops it and takes it out of the registry. */
    void releaseService();

    /** Called before everything is shut down. */
    void preShutdown();

    /** Whether its threads run. */
    boolean isRunning();

    /** Whether it can be used. */
    boolean isReady();

    /** Whether it is the Runtime. */
    boolean isRuntime();

    /** Whether it does without hardware. */
    boolean isVirtual();

    /** Does without hardware. */
    boolean setVirtual(boolean virtual);

    /** Name with the id of the process: name@id. */
    String getFullName();

    /** Id of the process. */
    String getId();

    /** Full class name. */
    String getTypeKey();

    /** Its number in the order of creation. */
    int getCreationOrder();

    /** Sets its number in the order of creation. */
    void setOrder(int order);

    /**
     * What it is for.
     *
     * @throws RuntimeException if its type has no meta data
     */
    String getDescription();

    /** Data of its type. */
    MetaData getMetaData();

    /** What comes in. */
    Inbox getInbox();

    /** What goes out. */
    Outbox getOutbox();

    /** All listeners by published method. */
    Map<String, List<MRLListener>> getNotifyList();

    /** The listeners of a published method. */
    List<MRLListener> getNotifyList(String key);

    /** The methods that have listeners. */
    List<String> getNotifyListKeySet();

    /** The present configuration. */
    ServiceConfig getConfig();

    /** The configuration as it is saved. */
    ServiceConfig getFilteredConfig();

    /** Adds the listeners to a configuration. */
    ServiceConfig addConfigListeners(ServiceConfig config);

    /** Sets one field of the configuration. */
    void setConfigValue(String fieldName, Object value) throws IllegalAccessException, NoSuchFieldException;

    /** The services that belong to this one. */
    Map<String, Peer> getPeers();

    /** Keys of the services that belong to this one. */
    Set<String> getPeerKeys();

    /** Key of one of its own services. */
    String getPeerKey(String name);

    /** Starts one of its own services. */
    ServiceInterface startPeer(String key);

    /** Starts some of its own services. */
    void startPeers(String[] keys);

    /** Releases one of its own services. */
    void releasePeer(String key);

    /** Releases some of its own services. */
    void releasePeers(String[] keys);

    /** Publishes as the named method. */
    void out(String method, Object data);

    /** Whether there was an error. */
    boolean hasError();

    /** Forgets the last error and answers its text. */
    String clearLastError();

    /** Names of its public methods. */
    String[] getMethodNames();
}
