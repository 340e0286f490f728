// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.io.Serializable;
import java.util.Objects;

/** A subscription: calls a method of another service with the result of a published method. */
public final class MRLListener implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The published method, for example publishRX. */
    public String topicMethod;
    /** Name of the listening service. */
    public String callbackName;
    /** The method called there, for example onRX. */
    public String callbackMethod;

    public MRLListener() {
    }

    public MRLListener(String topicMethod, String callbackName, String callbackMethod) {
        this.topicMethod = topicMethod;
        this.callbackName = callbackName;
        this.callbackMethod = callbackMethod;
    }

    @Override
    public boolean equals(Object other) {
        if (!(other instanceof MRLListener)) {
            return false;
        }
        MRLListener that = (MRLListener) other;
        return Objects.equals(topicMethod, that.topicMethod) && Objects.equals(callbackName, that.callbackName)
            && Objects.equals(callbackMethod, that.callbackMethod);
    }

    @Override
    public int hashCode() {
        return Objects.hash(topicMethod, callbackName, callbackMethod);
    }

    @Override
    public String toString() {
        return topicMethod + " --> " + callbackName + "." + callbackMethod;
    }
}
