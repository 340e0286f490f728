package org.myrobotlab.framework.interfaces;

import java.util.Set;

/** Two of these can be attached to each other. */
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

    /** Names of all that listen. */
    Set<String> getAttached();

    /** Names of all that listen to a method. */
    Set<String> getAttached(String publishingPoint);

    /** Whether the other listens. */
    boolean isAttached(Attachable instance);

    /** Whether the other listens. */
    boolean isAttached(String name);

    /** Calls onX of the other when publishX is published here. */
    void addListener(String topicMethod, String callbackName);

    /** Calls a method of the other when this one publishes. */
    void addListener(String topicMethod, String callbackName, String callbackMethod);

    /** Ends addListener. */
    void removeListener(String topicMethod, String callbackName);

    /** Ends addListener. */
    void removeListener(String topicMethod, String callbackName, String callbackMethod);

    /** Whether it lives in this process. */
    boolean isLocal();

    /** Whether it has the interface of that full name. */
    boolean hasInterface(String name);

    /** Whether it has the interface. */
    boolean hasInterface(Class<?> interfaze);

    /** Whether it is of that type. */
    boolean isType(Class<?> clazz);

    /** Whether it is of that type, given with or without package. */
    boolean isType(String clazz);
}
