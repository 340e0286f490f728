// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.lockstep;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.myrobotlab.framework.MRLListener;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Runtime;

/**
 * Services of this MyRobotLab whose queues may hold messages that scripts wait for; a snapshot. Ignores messages to
 * SEAR itself.
 */
final class ServiceQueues {
    private final String self;
    private final Collection<ServiceInterface> services;
    private final Set<ServiceInterface> receivers = new LinkedHashSet<>();
    private final List<ServiceInterface> publishers = new ArrayList<>();

    /** @param self name of the SEAR service */
    ServiceQueues(String self) {
        this.self = self;
        services = Runtime.getServices();
        for (ServiceInterface service : services) {
            boolean hasListeners = addListeners(service);
            if (service.getOutbox() != null && service.getOutbox().isRunning()
                && (hasListeners || service.getOutbox().size() > 0)) {
                publishers.add(service);
            }
            if (isWaiting(service)) {
                receivers.add(service);
            }
        }
        receivers.removeIf(service -> !service.isRunning() || !service.isLocal());
    }

    private boolean addListeners(ServiceInterface service) {
        boolean found = false;
        Map<String, List<MRLListener>> topics = service.getOutbox() == null ? Map.of() : service.getNotifyList();
        for (List<MRLListener> listeners : topics.values()) {
            for (MRLListener listener : listeners) {
                ServiceInterface receiver = Runtime.getService(listener.callbackName);
                if (receiver != null && !isSelf(receiver)) {
                    receivers.add(receiver);
                    found = true;
                }
            }
        }
        return found;
    }

    private boolean isSelf(ServiceInterface service) {
        return service.getName().equals(self);
    }

    private boolean isWaiting(ServiceInterface service) {
        return !isSelf(service) && service.getInbox() != null && service.getInbox().size() > 0;
    }

    /** Returns the services that have listeners or outgoing messages. */
    List<ServiceInterface> getPublishers() {
        return publishers;
    }

    /** Returns the services that are listeners or have incoming messages. */
    Set<ServiceInterface> getReceivers() {
        return receivers;
    }

    /** Returns whether a queue holds a message; a message in progress doesn't count. */
    boolean hold() {
        return publishers.stream().anyMatch(service -> service.getOutbox().size() > 0) || services.stream()
            .anyMatch(this::isWaiting);
    }
}
