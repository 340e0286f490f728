// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.myrobotlab.framework.interfaces.ServiceInterface;

/** All services of this process by full name, in the order of creation. Any thread. */
public final class Registry {
    /** Id of this process, the part of a full name after the @. */
    public static final String ID = "embedded";

    private final Map<String, ServiceInterface> services = new LinkedHashMap<>();

    public synchronized ServiceInterface get(String fullName) {
        return services.get(fullName);
    }

    public synchronized void put(ServiceInterface service) {
        services.put(service.getFullName(), service);
    }

    /**
     * Removes a service.
     *
     * @return whether it was registered
     */
    public synchronized boolean remove(String fullName) {
        return services.remove(fullName) != null;
    }

    public synchronized Map<String, ServiceInterface> copy() {
        return new LinkedHashMap<>(services);
    }

    /** Returns the services, the newest first. */
    public synchronized List<ServiceInterface> newestFirst() {
        List<ServiceInterface> all = new ArrayList<>(services.values());
        java.util.Collections.reverse(all);
        return all;
    }
}
