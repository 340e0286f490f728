// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.lang.reflect.Method;
import java.util.Arrays;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.embedded.python.PythonEngine;
import org.myrobotlab.framework.Status;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.meta.abstracts.MetaData;

/** Name, id and type of a service. */
public abstract class NamedService implements ServiceInterface {
    protected MetaData serviceType;
    protected String id;
    protected String simpleName;
    protected String typeKey;
    protected boolean isVirtual;
    private final String name;
    private int creationOrder;

    protected NamedService(String name, String id) {
        this.name = CodecUtils.getShortName(name);
        this.id = id;
        simpleName = getClass().getSimpleName();
        typeKey = getClass().getName();
        if (MetaData.class.getClassLoader()
            .getResource("org/myrobotlab/service/meta/" + simpleName + "Meta.class") != null) {
            serviceType = MetaData.get(typeKey);
        }
    }

    @Override
    public String getName() {
        return name;
    }

    @Override
    public String getFullName() {
        return name + "@" + id;
    }

    @Override
    public String getId() {
        return id;
    }

    @Override
    public String getSimpleName() {
        return simpleName;
    }

    @Override
    public String getTypeKey() {
        return typeKey;
    }

    @Override
    public int getCreationOrder() {
        return creationOrder;
    }

    @Override
    public void setOrder(int order) {
        creationOrder = order;
    }

    @Override
    public int compareTo(ServiceInterface other) {
        return Integer.compare(creationOrder, other.getCreationOrder());
    }

    @Override
    public String getDescription() {
        return getMetaData().getDescription();
    }

    /** @throws IllegalArgumentException if the type has no class XMeta */
    @Override
    public MetaData getMetaData() {
        return serviceType == null ? MetaData.get(typeKey) : serviceType;
    }

    @Override
    public boolean isRuntime() {
        return false;
    }

    @Override
    public boolean isLocal() {
        return true;
    }

    @Override
    public boolean isVirtual() {
        return isVirtual;
    }

    @Override
    public boolean setVirtual(boolean virtual) {
        isVirtual = virtual;
        return virtual;
    }

    @Override
    public boolean isType(Class<?> clazz) {
        return getClass() == clazz;
    }

    @Override
    public boolean isType(String clazz) {
        return clazz != null && (clazz.equals(typeKey) || clazz.equals(simpleName));
    }

    @Override
    public boolean hasInterface(Class<?> interfaze) {
        return interfaze.isInstance(this);
    }

    @Override
    public boolean hasInterface(String interfaceName) {
        for (Class<?> at = getClass(); at != null; at = at.getSuperclass()) {
            for (Class<?> one : at.getInterfaces()) {
                if (one.getName().equals(interfaceName) || one.getSimpleName().equals(interfaceName)) {
                    return true;
                }
            }
        }
        return false;
    }

    @Override
    public String[] getMethodNames() {
        return Arrays.stream(getClass().getMethods()).filter(method -> method.getDeclaringClass() != Object.class)
            .map(Method::getName).distinct().sorted().toArray(String[]::new);
    }

    @Override
    public String toString() {
        return getName();
    }

    /**
     * Publishes an error of a call that, as in the real MyRobotLab, throws nothing. A script that made the call
     * continues, and ends with status 1.
     */
    protected final Status failCall(String format, Object... args) {
        Status status = error(format, args);
        PythonEngine.failHere(status.detail);
        return status;
    }
}
