// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.SEAR.geometry.Pose;

/**
 * A class whose fields become a JSON object, in their order, those of the superclass first. A null field is omitted; an
 * {@link Optional} is always present, null if it is empty. Complete an object before other threads use it.
 */
abstract class JsonForm {
    private static final ClassValue<List<Field>> FIELDS = new ClassValue<>() {
        @Override
        protected List<Field> computeValue(Class<?> type) {
            List<Field> fields = new ArrayList<>(type == Object.class ? List.of() : get(type.getSuperclass()));
            for (Field field : type.getDeclaredFields()) {
                if ((field.getModifiers() & (Modifier.STATIC | Modifier.TRANSIENT)) == 0 && !field.isSynthetic()) {
                    fields.add(field);
                }
            }
            return fields;
        }
    };

    /** Constant fields besides the declared ones, which they follow; each value as JSON libraries take it. */
    transient Map<String, Object> more = Map.of();

    /**
     * Returns the fields as maps, lists, arrays, numbers and texts, which every JSON library and Python script can
     * read.
     */
    Map<String, Object> map() {
        Map<String, Object> map = fields(this);
        map.putAll(more);
        return map;
    }

    /** Returns the declared fields of any object as {@link #map} does. */
    static Map<String, Object> fields(Object of) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (Field field : FIELDS.get(of.getClass())) {
            Object value = get(field, of);
            if (value != null) {
                map.put(field.getName(), plain(value));
            }
        }
        return map;
    }

    /** Returns the fields that differ from another object of the class; null for fields that only the other has. */
    Map<String, Object> since(JsonForm before) {
        Map<String, Object> changed = new LinkedHashMap<>();
        for (Field field : FIELDS.get(getClass())) {
            Object value = plain(get(field, this));
            if (!Objects.deepEquals(value, plain(get(field, before)))) {
                changed.put(field.getName(), value);
            }
        }
        return changed;
    }

    private static Object get(Field field, Object of) {
        try {
            return field.get(of);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(field + " is hidden from this package", e);
        }
    }

    /** Returns a value as JSON libraries take it; a pose as {x, y, z, rx, ry, rz}. */
    static Object plain(Object value) {
        if (value instanceof Optional) {
            return plain(((Optional<?>) value).orElse(null));
        }
        if (value instanceof Pose) {
            return JsonNumbers.numbers((Pose) value);
        }
        if (value instanceof List && !((List<?>) value).isEmpty()) {
            List<?> list = (List<?>) value;
            return list.get(0) instanceof Pose ? list.stream().map(JsonForm::plain).toArray(double[][]::new)
                : list.get(0) instanceof JsonForm ? list.stream().map(JsonForm::plain)
                .collect(Collectors.toList()) : list;
        }
        if (value instanceof ScanRanges) {
            return ((ScanRanges) value).text();
        }
        return value instanceof JsonForm ? ((JsonForm) value).map() : value;
    }
}
