package org.myrobotlab.service.interfaces;

import org.myrobotlab.framework.Registration;
import org.myrobotlab.framework.interfaces.NameProvider;

/** Is told when services come and go. */
public interface ServiceLifeCycleListener extends NameProvider {
    /** A service was made. */
    void onCreated(String name);

    /** A service is in the registry. */
    void onRegistered(Registration registration);

    /** A service runs. */
    void onStarted(String name);

    /** A service no longer runs. */
    void onStopped(String name);

    /** A service is gone. */
    void onReleased(String name);
}
