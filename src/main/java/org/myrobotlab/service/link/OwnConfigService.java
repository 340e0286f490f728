// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.ServiceConfig;

/**
 * A service that accepts only its own type of configuration. MyRobotLab itself applies any configuration to any
 * service, and the service then fails when it reads it. Any thread.
 *
 * @param <T> type of the configuration
 */
public abstract class OwnConfigService<T extends ServiceConfig> extends Service<T> {
    private static final long serialVersionUID = 1L;

    protected OwnConfigService(String name, String id) {
        super(name, id);
    }

    /** Returns the type of the configuration. */
    protected abstract Class<T> configType();

    /** @throws IllegalArgumentException if the configuration is null or of another type; the present one stays */
    @Override
    public T apply(T newConfig) {
        if (!configType().isInstance(newConfig)) {
            throw new IllegalArgumentException("the configuration of " + getName() + " is a "
                + (newConfig == null ? null : newConfig.getClass().getSimpleName()) + ", legal: " + configType()
                    .getSimpleName());
        }
        return super.apply(newConfig);
    }
}
