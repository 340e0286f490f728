package org.myrobotlab.service.interfaces;

import java.util.List;
import org.myrobotlab.framework.Registration;
import org.myrobotlab.framework.interfaces.NameProvider;

/** Tells when services come and go. */
public interface ServiceLifeCyclePublisher extends NameProvider {
    /** Tells another of all that happens. */
    default void attachServiceLifeCycleListener(String name) {
        for (String topic : List.of("created", "registered", "started", "stopped", "released")) {
            addListener(topic, name);
        }
    }

    /** Ends {@link #attachServiceLifeCycleListener}. */
    default void detachServiceLifeCycleListener(String name) {
        for (String topic : List.of("created", "registered", "started", "stopped", "released")) {
            removeListener(topic, name);
        }
    }

    void addListener(String topicMethod, String name);

    void removeListener(String topicMethod, String name);

    /** A service was made. */
    String created(String name);

    /** A service is in the registry. */
    Registration registered(Registration registration);

    /** A service runs. */
    String started(String name);

    /** A service no longer runs. */
    String stopped(String name);

    /** A service is gone. */
    String released(String name);
}
