// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.service.config.ServiceConfig;

/** A service with a configuration. */
public interface ConfigurableService<T extends ServiceConfig> {
    /** The current configuration. */
    T getConfig();

    /** Applies a configuration. */
    T apply(T config);
}
