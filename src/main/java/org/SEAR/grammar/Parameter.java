// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.lang.reflect.Field;
import java.lang.reflect.ParameterizedType;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;

/** One parameter of a class of the grammar, read from a field and its {@link Param}. Immutable, any thread. */
public final class Parameter {
    /** Kind of value. */
    public enum Kind {
        /** A finite number. */
        NUMBER,
        /** A whole number. */
        WHOLE,
        /** true or false. */
        SWITCH,
        /** A line of text. */
        TEXT,
        /** A group of parameters. */
        GROUP
    }

    private static final Pattern PLAIN_NUMBER =
        Pattern.compile("[-+]?[0-9]*\\.?[0-9]+([eE][-+]?[0-9]+)?|[-+]?[0-9]+\\.");

    /**
     * Decimal digits that every double preserves. A number that needs at most {@link #PLAIN} of them is written
     * rounded.
     */
    private static final MathContext CERTAIN = new MathContext(15);
    private static final int PLAIN = 10;

    /** The {@link Included} field that holds the parameter; null for a field of the object itself. */
    private final Field group;
    private final Field field;
    private final Param param;
    private final Class<?> type;
    private final Kind kind;

    /** @param group the {@link Included} field that holds the parameter; null for a field of the object itself */
    Parameter(Field group, Field field) {
        this.group = group;
        this.field = field;
        this.param = field.getAnnotation(Param.class);
        this.type = isList() ? (Class<?>) ((ParameterizedType) field.getGenericType()).getActualTypeArguments()[0]
            : field.getType();
        this.kind = kindOf(type);
        field.setAccessible(true);
        if (group != null) {
            group.setAccessible(true);
        }
    }

    private static Kind kindOf(Class<?> type) {
        if (type == double.class || type == Double.class) {
            return Kind.NUMBER;
        }
        if (type == int.class || type == Integer.class) {
            return Kind.WHOLE;
        }
        if (type == boolean.class || type == Boolean.class) {
            return Kind.SWITCH;
        }
        return type == String.class ? Kind.TEXT : Kind.GROUP;
    }

    /** Returns the name of the XML element. */
    public String getName() {
        return param.element().isEmpty() ? field.getName() : param.element();
    }

    public String getDoc() {
        return param.doc();
    }

    /** Returns the unit; may be empty. */
    public String getUnit() {
        return param.unit();
    }

    public Kind getKind() {
        return kind;
    }

    public double getMin() {
        return param.min();
    }

    public double getMax() {
        return param.max();
    }

    public TextRule getTextRule() {
        return param.text();
    }

    public boolean isList() {
        return field.getType() == List.class;
    }

    /** Returns the largest number of entries in a list; 1 for a single value. */
    public int getMaxEntries() {
        return param.maxEntries();
    }

    /** Returns whether a file without the element is invalid. */
    public boolean isRequired() {
        return param.required();
    }

    /** Returns the only legal texts or whole numbers; empty for no such restriction. */
    public List<String> getValues() {
        return List.of(param.values());
    }

    /** Returns one word of explanation for each of the values; empty if the values explain themselves. */
    public List<String> getWords() {
        return List.of(param.words());
    }

    /** Returns the class of the parts that the text names, see {@link Param#names}; empty if it names none. */
    public String getNamed() {
        return param.names() == void.class ? "" : param.names().getSimpleName();
    }

    /** Returns whether the text may be the name of this part. */
    public boolean isNameOf(Object thing) {
        return param.names().isInstance(thing);
    }

    /** Returns whether an object without any value of this parameter is invalid or useless. */
    public boolean isNeeded() {
        return param.required() || param.needed();
    }

    /** Returns whether 0 is legal although it is below the smallest legal number. */
    public boolean isOrZero() {
        return param.orZero();
    }

    /**
     * Returns the value of an object that is created with a name only, as text. A required number without such a value
     * starts with the legal number nearest to 1.
     *
     * @return empty if the object starts with the default, or if the user has to give the value
     */
    public String getInitial() {
        boolean number = kind == Kind.NUMBER || kind == Kind.WHOLE;
        return param.initial().isEmpty() && param.required()
            && number ? format(Math.max(param.min(), Math.min(param.max(), 1))) : param.initial();
    }

    /** Returns the class of a group's parameters; for other kinds the type of the value. */
    public Class<?> getType() {
        return type;
    }

    /** Returns the legal values in words: {@code a number from 0 to 1000000 kg}. */
    public String legal() {
        if (param.values().length > 0) {
            return String.join(", ", param.values()) + (param.unit().isEmpty() ? "" : " " + param.unit());
        }
        switch (kind) {
            case NUMBER:
                return (param.orZero() ? "0, or " : "") + "a number from " + range();
            case WHOLE:
                return "a whole number from " + range();
            case SWITCH:
                return "true or false";
            case TEXT:
                return param.text().legal();
            default:
                return "a group of " + String.join(", ", ParameterTable.of(type).names());
        }
    }

    private String range() {
        return format(param.min()) + " to " + format(param.max()) + (param.unit().isEmpty() ? "" : " " + param.unit());
    }

    /**
     * Returns whether a single value (an entry of a list) is legal. Null is legal for an optional text, group, Double,
     * Integer or Boolean.
     */
    public boolean isLegal(Object value) {
        if (value == null) {
            return !param.required() && !type.isPrimitive();
        }
        switch (kind) {
            case NUMBER:
            case WHOLE:
                double number = ((Number) value).doubleValue();
                return (number >= param.min() && number <= param.max() || param.orZero() && number == 0)
                    && isListed(format(number));
            case TEXT:
                return param.text().isLegal((String) value) && isListed((String) value);
            default:
                return true;
        }
    }

    private boolean isListed(String text) {
        return param.values().length == 0 || Arrays.asList(param.values()).contains(text);
    }

    /**
     * Parses a value from its text in a file.
     *
     * @throws IllegalArgumentException with the legal values, if the text is of another kind or not legal
     */
    public Object parse(String text) {
        String trimmed = text.trim();
        Object value;
        switch (kind) {
            case NUMBER:
                value = Double.parseDouble(plainNumber(trimmed)) + 0.0;
                break;
            case WHOLE:
                value = Integer.parseInt(plainNumber(trimmed));
                break;
            case SWITCH:
                if (!trimmed.equals("true") && !trimmed.equals("false")) {
                    throw new IllegalArgumentException(legal());
                }
                value = trimmed.equals("true");
                break;
            default:
                value = param.text() == TextRule.DRAWING ? text.stripTrailing() : trimmed;
                break;
        }
        if (!isLegal(value)) {
            throw new IllegalArgumentException(legal());
        }
        return value;
    }

    /** Rejects 1f, 0x1p3 and NaN, which Java parses as numbers: a file has digits, sign, point and exponent only. */
    private String plainNumber(String text) {
        if (text.length() > 40 || !PLAIN_NUMBER.matcher(text).matches()) {
            throw new IllegalArgumentException(legal());
        }
        return text;
    }

    /** Returns the value in an object: a boxed number, Boolean, String, group, List, or null. */
    public Object get(Object object) {
        try {
            return field.get(holder(object));
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Sets the value in an object without a check. */
    public void set(Object object, Object value) {
        try {
            field.set(holder(object), value);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
    }

    private Object holder(Object object) throws IllegalAccessException {
        return group == null ? object : group.get(object);
    }

    /** Returns the values in an object as a list: the entries, the single value, or nothing for null. */
    public List<Object> values(Object object) {
        Object value = get(object);
        List<Object> values = new ArrayList<>();
        if (value instanceof List) {
            values.addAll((List<?>) value);
        } else if (value != null) {
            values.add(value);
        }
        return values;
    }

    /**
     * Formats a value as in a file: {@code 0.25}, {@code 10}, {@code true}. Rounding errors in the last digits are
     * dropped: {@code 6 * 0.8 + 1} is 5.8, not 5.800000000000001. Every other number reads back unchanged.
     */
    public static String format(Object value) {
        if (!(value instanceof Double)) {
            return String.valueOf(value);
        }
        double number = (Double) value;
        double size = Math.abs(number);
        if (size != 0 && (size < 1e-9 || size >= 1e15) || Double.isNaN(number)) {
            return Double.toString(number);
        }
        BigDecimal exact = new BigDecimal(Double.toString(number));
        BigDecimal rounded = exact.round(CERTAIN).stripTrailingZeros();
        BigDecimal decimal = rounded.precision() <= PLAIN ? rounded : exact.stripTrailingZeros();
        return decimal.signum() == 0 ? "0" : decimal.toPlainString();
    }
}
