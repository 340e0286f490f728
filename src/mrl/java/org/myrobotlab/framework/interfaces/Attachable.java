// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import java.util.Set;

/** A service that can be attached to another. */
public interface Attachable extends NameProvider {
    /** Attaches another. */
    void attach(Attachable service) throws Exception;

    /** Attaches another. */
    void attach(String name) throws Exception;

    /** Ends an attachment. */
    void detach(Attachable service);

    /** Ends an attachment. */
    void detach(String name);

    /** Ends all attachments. */
    void detach();

    /** Names of all listeners. */
    Set<String> getAttached();

    /** Names of the listeners of a method. */
    Set<String> getAttached(String publishingPoint);

    /** Whether the other service listens. */
    boolean isAttached(Attachable instance);

    /** Whether the other service listens. */
    boolean isAttached(String name);

    /** Calls onX of the other service when this one publishes publishX. */
    void addListener(String topicMethod, String callbackName);

    /** Calls a method of the other service when this one publishes. */
    void addListener(String topicMethod, String callbackName, String callbackMethod);

    /** Removes a listener. */
    void removeListener(String topicMethod, String callbackName);

    /** Removes a listener. */
    void removeListener(String topicMethod, String callbackName, String callbackMethod);

    /** Whether it belongs to this process. */
    boolean isLocal();

    /** Whether it has the interface, given by its full or simple name. */
    boolean hasInterface(String name);

    /** Whether it has the interface. */
    boolean hasInterface(Class<?> interfaze);

    /** Whether it is of that type. */
    boolean isType(Class<?> clazz);

    /** Whether it is of that type, given with or without package. */
    boolean isType(String clazz);
}
