// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.myrobotlab.service.config.ServiceConfig;

/** Services to be created, with their configurations. */
public class Plan {
    protected Map<String, ServiceConfig> config = new LinkedHashMap<>();
    private final String name;

    public Plan(String rootName) {
        name = rootName;
    }

    public ServiceConfig put(String serviceName, ServiceConfig serviceConfig) {
        return config.put(serviceName, serviceConfig);
    }

    public ServiceConfig get(String serviceName) {
        return config.get(serviceName);
    }

    public ServiceConfig remove(String serviceName) {
        return config.remove(serviceName);
    }

    public boolean containsKey(String serviceName) {
        return config.containsKey(serviceName);
    }

    public Set<String> keySet() {
        return config.keySet();
    }

    public Map<String, ServiceConfig> getConfig() {
        return config;
    }

    public int size() {
        return config.size();
    }

    public void clear() {
        config.clear();
    }

    @Override
    public String toString() {
        return name + " " + config.keySet();
    }
}
