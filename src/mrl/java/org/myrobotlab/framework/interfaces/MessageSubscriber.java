// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

/** Subscribes to methods of other services. */
public interface MessageSubscriber {
    /** Calls onX when the other service publishes publishX. */
    void subscribe(NameProvider topicName, String topicMethod);

    /** Calls onX when the other service publishes publishX. */
    void subscribe(String topicName, String topicMethod);

    /** Calls the given method when the other service publishes. */
    void subscribe(String topicName, String topicMethod, String callbackMethod);

    /** Ends a subscription. */
    void unsubscribe(NameProvider topicName, String topicMethod);

    /** Ends a subscription. */
    void unsubscribe(String topicName, String topicMethod);

    /** Ends a subscription. */
    void unsubscribe(String topicName, String topicMethod, String callbackMethod);
}
