// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import com.fasterxml.jackson.annotation.JsonAutoDetect;
import com.fasterxml.jackson.annotation.PropertyAccessor;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;

/** Objects as JSON: all fields, including private ones, except static and transient ones. Any thread. */
public final class Json {
    private static final int DEEPEST = 500;
    private static final int LONGEST_NUMBER = 1000;
    private static final String OF_NUMBERS = "0123456789+-.eE";
    private static final ObjectMapper MAPPER = new ObjectMapper()
        .setVisibility(PropertyAccessor.ALL, JsonAutoDetect.Visibility.NONE)
        .setVisibility(PropertyAccessor.FIELD, JsonAutoDetect.Visibility.ANY)
        .setVisibility(PropertyAccessor.CREATOR, JsonAutoDetect.Visibility.ANY)
        .disable(SerializationFeature.FAIL_ON_EMPTY_BEANS)
        .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
        .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS);

    private Json() {
    }

    /** @throws IllegalArgumentException if the object can't be written */
    public static String write(Object object) {
        try {
            return MAPPER.writeValueAsString(object);
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("can't write " + object.getClass().getName() + " as JSON: "
                + e.getOriginalMessage(), e);
        }
    }

    /**
     * Reads JSON.
     *
     * @throws IllegalArgumentException if the text is not JSON of this type, is nested more than {@value #DEEPEST}
     *     levels deep, or has a number of more than {@value #LONGEST_NUMBER} digits
     */
    public static <T> T read(String json, Class<T> type) {
        checkLimits(json);
        try {
            T value = MAPPER.readValue(json, type);
            if (value == null && type != Object.class) {
                throw new IllegalArgumentException("not JSON for " + type.getSimpleName() + ": null");
            }
            return value;
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("not JSON for " + type.getSimpleName() + ": "
                + e.getOriginalMessage(), e);
        }
    }

    /** Protects the mapper, which recurses for each nested list and needs minutes for a number of a million digits. */
    private static void checkLimits(String json) {
        int depth = 0;
        int digits = 0;
        boolean isText = false;
        for (int i = 0; i < json.length(); i++) {
            char at = json.charAt(i);
            if (isText && at == '\\') {
                i++;
            } else if (at == '"') {
                isText = !isText;
            } else if (!isText && (at == '[' || at == '{')) {
                depth++;
            } else if (!isText && (at == ']' || at == '}')) {
                depth--;
            }
            digits = !isText && OF_NUMBERS.indexOf(at) >= 0 ? digits + 1 : 0;
            if (digits > LONGEST_NUMBER) {
                throw new IllegalArgumentException("JSON with a number of more than " + LONGEST_NUMBER + " digits");
            }
            if (depth > DEEPEST) {
                throw new IllegalArgumentException("JSON nested more than " + DEEPEST + " levels deep");
            }
        }
    }

    /**
     * Converts a value read as plain JSON into an object of the type.
     *
     * @throws IllegalArgumentException if the value doesn't fit the type
     */
    public static Object convert(Object value, java.lang.reflect.Type type) {
        return MAPPER.convertValue(value, MAPPER.constructType(type));
    }
}
