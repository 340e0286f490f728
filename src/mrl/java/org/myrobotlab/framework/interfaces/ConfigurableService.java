package org.myrobotlab.framework.interfaces;

import org.myrobotlab.service.config.ServiceConfig;

/** Has a configuration. */
public interface ConfigurableService<T extends ServiceConfig> {
    /** The present configuration. */
    T getConfig();

    /** Takes a configuration over. */
    T apply(T config);
}
