package org.myrobotlab.framework.interfaces;

/** Has itself called back when another service publishes. */
public interface MessageSubscriber {
    /** Calls onX when the other publishes publishX. */
    void subscribe(NameProvider topicName, String topicMethod);

    /** Calls onX when the other publishes publishX. */
    void subscribe(String topicName, String topicMethod);

    /** Calls the given method when the other publishes. */
    void subscribe(String topicName, String topicMethod, String callbackMethod);

    /** Ends a subscription. */
    void unsubscribe(NameProvider topicName, String topicMethod);

    /** Ends a subscription. */
    void unsubscribe(String topicName, String topicMethod);

    /** Ends a subscription. */
    void unsubscribe(String topicName, String topicMethod, String callbackMethod);
}
