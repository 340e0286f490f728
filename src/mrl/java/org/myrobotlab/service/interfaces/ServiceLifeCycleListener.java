// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

import org.myrobotlab.framework.Registration;
import org.myrobotlab.framework.interfaces.NameProvider;

/** Gets called when services are created, started, stopped or released. */
public interface ServiceLifeCycleListener extends NameProvider {
    /** Called when a service was created. */
    void onCreated(String name);

    /** Called when a service was registered. */
    void onRegistered(Registration registration);

    /** Called when a service was started. */
    void onStarted(String name);

    /** Called when a service was stopped. */
    void onStopped(String name);

    /** Called when a service was released. */
    void onReleased(String name);
}
