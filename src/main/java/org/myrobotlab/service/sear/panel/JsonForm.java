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

/**
 * A class whose fields become a JSON object, in their order, those of the superclass first. A null field is omitted; an
 * {@link Optional} is always present, null if it is empty. Complete an object before other threads use it.
 */
abstract class JsonForm {
    private static final ClassValue<List<Field>> FIELDS = new ClassValue<>() {
        @Override
        protected List<Field> computeValue(Class<?> type) {
            List<Field> fields = new ArrayList<>(type == JsonForm.class ? List.of() : get(type.getSuperclass()));
            for (Field field : type.getDeclaredFields()) {
                if (!Modifier.isStatic(field.getModifiers()) && !field.isSynthetic()) {
                    fields.add(field);
                }
            }
            return fields;
        }
    };

    /**
     * Returns the fields as maps, lists, arrays, numbers and texts, which every JSON library and Python script can
     * read.
     */
    Map<String, Object> map() {
        Map<String, Object> map = new LinkedHashMap<>();
        for (Field field : FIELDS.get(getClass())) {
            Object value = get(field);
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
            Object value = plain(get(field));
            if (!Objects.deepEquals(value, plain(before.get(field)))) {
                changed.put(field.getName(), value);
            }
        }
        return changed;
    }

    private Object get(Field field) {
        try {
            return field.get(this);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(field + " is hidden from this package", e);
        }
    }

    private static Object plain(Object value) {
        if (value instanceof Optional) {
            return plain(((Optional<?>) value).orElse(null));
        }
        if (value instanceof List && !((List<?>) value).isEmpty() && ((List<?>) value).get(0) instanceof JsonForm) {
            return ((List<?>) value).stream().map(JsonForm::plain).collect(Collectors.toList());
        }
        if (value instanceof ScanRanges) {
            return ((ScanRanges) value).text();
        }
        return value instanceof JsonForm ? ((JsonForm) value).map() : value;
    }
}
