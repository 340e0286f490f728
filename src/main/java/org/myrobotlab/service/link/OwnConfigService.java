package org.myrobotlab.service.link;

import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.ServiceConfig;

/**
 * A service that takes no configuration but its own. MyRobotLab takes any for any service, by a call of {@code apply} or out of a file, and the
 * service breaks when it looks into it. Any thread.
 *
 * @param <T> its configuration
 */
public abstract class OwnConfigService<T extends ServiceConfig> extends Service<T> {
    private static final long serialVersionUID = 1L;

    /** As MyRobotLab makes services. */
    protected OwnConfigService(String name, String id) {
        super(name, id);
    }

    /** What its configuration is. */
    protected abstract Class<T> configType();

    /** @throws IllegalArgumentException if it is another service's, or null; the present one stays */
    @Override
    public T apply(T newConfig) {
        if (!configType().isInstance(newConfig)) {
            throw new IllegalArgumentException("the configuration of " + getName() + " is a "
                + (newConfig == null ? null : newConfig.getClass().getSimpleName()) + ", legal: " + configType().getSimpleName());
        }
        return super.apply(newConfig);
    }
}
