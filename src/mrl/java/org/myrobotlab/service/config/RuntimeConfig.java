package org.myrobotlab.service.config;

import java.util.ArrayList;
import java.util.List;

/** Configuration of the Runtime. */
public class RuntimeConfig extends ServiceConfig {
    /** Id of this process. */
    public String id;
    /** Whether services do without hardware. */
    public Boolean virtual;
    public String locale;
    public String logLevel = "warn";
    /** The folder of panels and other resources. */
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
