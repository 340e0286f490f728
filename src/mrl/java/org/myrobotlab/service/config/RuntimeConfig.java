// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.config;

import java.util.ArrayList;
import java.util.List;

/** Configuration of the Runtime. */
public class RuntimeConfig extends ServiceConfig {
    /** Process id. */
    public String id;
    /** Whether services work without hardware. */
    public Boolean virtual;
    public String locale;
    public String logLevel = "warn";
    /** Folder of panels and other resources. */
    public String resource = "resource";
    /** Names of the services to start. */
    public List<String> registry = new ArrayList<>();

    public List<String> getRegistry() {
        return registry;
    }

    public synchronized void add(String name) {
        if (!registry.contains(name)) {
            registry.add(name);
        }
    }

    public synchronized boolean remove(String name) {
        return registry.remove(name);
    }

    public void clear() {
        registry.clear();
    }
}
