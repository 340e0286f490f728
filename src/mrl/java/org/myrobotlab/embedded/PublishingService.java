// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.framework.MRLListener;
import org.myrobotlab.framework.Outbox;
import org.myrobotlab.framework.interfaces.Attachable;
import org.myrobotlab.framework.interfaces.NameProvider;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Runtime;

/** Listeners and subscriptions of a service. */
public abstract class PublishingService extends NamedService {
    protected final transient Outbox outbox;

    protected PublishingService(String name, String id) {
        super(name, id);
        outbox = new Outbox(getName());
    }

    public void addListener(MRLListener listener) {
        List<MRLListener> listeners = outbox.getNotifyList()
            .computeIfAbsent(listener.topicMethod, topic -> new CopyOnWriteArrayList<>());
        if (!listeners.contains(listener)) {
            listeners.add(listener);
        }
    }

    @Override
    public void addListener(String topicMethod, String callbackName) {
        addListener(topicMethod, callbackName, CodecUtils.getCallbackTopicName(topicMethod));
    }

    @Override
    public void addListener(String topicMethod, String callbackName, String callbackMethod) {
        if (!ScriptPlace.here().isEmpty() && Arrays.stream(getClass().getMethods())
            .noneMatch(method -> method.getName().equals(topicMethod))) {
            String meant = NearestName.member(topicMethod, getClass());
            failCall("%s", "does not publish " + topicMethod + (meant.isEmpty() ? "" : "; " + meant));
        }
        addListener(new MRLListener(topicMethod, callbackName, callbackMethod));
    }

    @Override
    public void removeListener(String topicMethod, String callbackName) {
        removeListener(topicMethod, callbackName, CodecUtils.getCallbackTopicName(topicMethod));
    }

    @Override
    public void removeListener(String topicMethod, String callbackName, String callbackMethod) {
        List<MRLListener> listeners = outbox.getNotifyList().get(topicMethod);
        if (listeners != null) {
            listeners.removeIf(one -> one.callbackMethod.equals(callbackMethod)
                && CodecUtils.checkServiceNameEquality(one.callbackName, callbackName));
        }
    }

    public void removeAllListeners() {
        outbox.reset();
    }

    @Override
    public Map<String, List<MRLListener>> getNotifyList() {
        return outbox.getNotifyList();
    }

    @Override
    public List<MRLListener> getNotifyList(String key) {
        return outbox.getNotifyList().get(key);
    }

    @Override
    public ArrayList<String> getNotifyListKeySet() {
        return new ArrayList<>(outbox.getNotifyList().keySet());
    }

    public boolean hasSubscribed(String listener, String topicMethod) {
        return outbox.getAttached(topicMethod).stream()
            .anyMatch(one -> CodecUtils.checkServiceNameEquality(one, listener));
    }

    @Override
    public void subscribe(NameProvider topic, String topicMethod) {
        subscribe(topic.getName(), topicMethod);
    }

    @Override
    public void subscribe(String topicName, String topicMethod) {
        subscribe(topicName, topicMethod, CodecUtils.getCallbackTopicName(topicMethod));
    }

    @Override
    public void subscribe(String topicName, String topicMethod, String callbackMethod) {
        subscribe(topicName, topicMethod, getFullName(), callbackMethod);
    }

    public void subscribe(String topicName, String topicMethod, String callbackName, String callbackMethod) {
        ServiceInterface topic = Runtime.getService(topicName);
        if (topic == null) {
            failCall("can't listen to %s of %s: there is no such service", topicMethod, topicName);
        } else {
            topic.addListener(topicMethod, callbackName, callbackMethod);
        }
    }

    public void subscribeToRuntime(String topicMethod) {
        subscribe(Runtime.getInstance().getName(), topicMethod);
    }

    @Override
    public void unsubscribe(NameProvider topic, String topicMethod) {
        unsubscribe(topic.getName(), topicMethod);
    }

    @Override
    public void unsubscribe(String topicName, String topicMethod) {
        unsubscribe(topicName, topicMethod, CodecUtils.getCallbackTopicName(topicMethod));
    }

    @Override
    public void unsubscribe(String topicName, String topicMethod, String callbackMethod) {
        unsubscribe(topicName, topicMethod, getFullName(), callbackMethod);
    }

    public void unsubscribe(String topicName, String topicMethod, String callbackName, String callbackMethod) {
        ServiceInterface topic = Runtime.getService(topicName);
        if (topic != null) {
            topic.removeListener(topicMethod, callbackName, callbackMethod);
        }
    }

    @Override
    public void attach(String other) throws Exception {
        attach((Attachable) Runtime.getService(other));
    }

    @Override
    public void attach(Attachable other) throws Exception {
        failCall("%s can't attach %s: services of its type take no attachments", getName(), other == null ? null
            : other.getName());
    }

    @Override
    public void detach(Attachable other) {
        detach(other.getName());
    }

    @Override
    public void detach(String other) {
        outbox.detach(other);
    }

    @Override
    public void detach() {
        outbox.reset();
    }

    @Override
    public Set<String> getAttached() {
        return outbox.getAttached(null);
    }

    @Override
    public Set<String> getAttached(String publishingPoint) {
        return outbox.getAttached(publishingPoint);
    }

    @Override
    public boolean isAttached(Attachable other) {
        return isAttached(other.getName());
    }

    @Override
    public boolean isAttached(String other) {
        return hasSubscribed(other, null);
    }
}
