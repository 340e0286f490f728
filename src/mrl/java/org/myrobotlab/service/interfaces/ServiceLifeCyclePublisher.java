// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

import java.util.List;
import org.myrobotlab.framework.Registration;
import org.myrobotlab.framework.interfaces.NameProvider;

/** Publishes when services are created, registered, started, stopped or released. */
public interface ServiceLifeCyclePublisher extends NameProvider {
    /** Subscribes another service to all these events. */
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

    /** Publishes that a service was created. */
    String created(String name);

    /** Publishes that a service was registered. */
    Registration registered(Registration registration);

    /** Publishes that a service was started. */
    String started(String name);

    /** Publishes that a service was stopped. */
    String stopped(String name);

    /** Publishes that a service was released. */
    String released(String name);
}
