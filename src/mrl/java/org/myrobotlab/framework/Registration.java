// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.util.List;
import java.util.Objects;
import org.myrobotlab.framework.interfaces.ServiceInterface;

/** A service's entry in the registry. */
public class Registration {
    protected String id;
    protected String name;
    protected String typeKey;
    public List<String> interfaces;
    public String state;
    public transient ServiceInterface service;

    public Registration(String id, String name, String typeKey) {
        this.id = id;
        this.name = name;
        this.typeKey = typeKey;
    }

    public Registration(ServiceInterface service) {
        this(service.getId(), service.getName(), service.getTypeKey());
        this.service = service;
    }

    public String getName() {
        return name;
    }

    public String getId() {
        return id;
    }

    public String getTypeKey() {
        return typeKey;
    }

    public String getState() {
        return state;
    }

    public String getFullName() {
        return name + "@" + id;
    }

    public boolean isLocal(String processId) {
        return id.equals(processId);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Registration && getFullName().equals(((Registration) other).getFullName())
            && Objects.equals(typeKey, ((Registration) other).typeKey);
    }

    @Override
    public int hashCode() {
        return Objects.hash(name, id, typeKey);
    }

    @Override
    public String toString() {
        return getFullName() + " " + typeKey;
    }
}
