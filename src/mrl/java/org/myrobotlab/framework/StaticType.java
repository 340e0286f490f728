// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;

/** A type with its parameters, written as {@code new StaticType<List<String>>() {}}. */
public class StaticType<T> {
    private final transient Type type;

    protected StaticType() {
        type = ((ParameterizedType) getClass().getGenericSuperclass()).getActualTypeArguments()[0];
    }

    public Type getType() {
        return type;
    }

    /** Returns the class without its parameters. */
    @SuppressWarnings("unchecked")
    public Class<T> asClass() {
        return (Class<T>) (type instanceof ParameterizedType ? ((ParameterizedType) type).getRawType() : type);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof StaticType && type.equals(((StaticType<?>) other).type);
    }

    @Override
    public int hashCode() {
        return type.hashCode();
    }

    @Override
    public String toString() {
        return type.getTypeName();
    }
}
