package org.SEAR.grammar;

import java.lang.reflect.Field;
import java.lang.reflect.ParameterizedType;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;

/** The description of one parameter of a class of the grammar, taken from a field and its {@link Param}. Immutable, any thread. */
public final class Parameter {
    /** What kind of value a parameter has. */
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

    private static final Pattern PLAIN_NUMBER = Pattern.compile("[-+]?[0-9]*\\.?[0-9]+([eE][-+]?[0-9]+)?|[-+]?[0-9]+\\.");

    /** So many decimal digits a double keeps whatever they are; a number that they write with no more than {@link #PLAIN} was meant so. */
    private static final MathContext CERTAIN = new MathContext(15);
    private static final int PLAIN = 10;

    /** Where an included group of parameters is kept; null for a parameter of the object's own. */
    private final Field group;
    private final Field field;
    private final Param param;
    private final Class<?> type;
    private final Kind kind;

    /** @param group the {@link Included} field that the parameter comes with; null for one of the object's own */
    Parameter(Field group, Field field) {
        this.group = group;
        this.field = field;
        this.param = field.getAnnotation(Param.class);
        this.type = isList() ? (Class<?>) ((ParameterizedType) field.getGenericType()).getActualTypeArguments()[0] : field.getType();
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

    /** Name of the XML element. */
    public String getName() {
        return param.element().isEmpty() ? field.getName() : param.element();
    }

    /** What it means. */
    public String getDoc() {
        return param.doc();
    }

    /** Unit, may be empty. */
    public String getUnit() {
        return param.unit();
    }

    /** What kind of value it has. */
    public Kind getKind() {
        return kind;
    }

    /** Smallest legal number. */
    public double getMin() {
        return param.min();
    }

    /** Largest legal number. */
    public double getMax() {
        return param.max();
    }

    /** What a text has to look like. */
    public TextRule getTextRule() {
        return param.text();
    }

    /** Whether there may be several. */
    public boolean isList() {
        return field.getType() == List.class;
    }

    /** Most entries of a list; 1 for a single value. */
    public int getMaxEntries() {
        return param.maxEntries();
    }

    /** Whether a file has to have it. */
    public boolean isRequired() {
        return param.required();
    }

    /** The only legal texts or whole numbers; empty if any that fits the rest is. */
    public List<String> getValues() {
        return List.of(param.values());
    }

    /** What each of the values means, in a word; empty where the values say it themselves. */
    public List<String> getWords() {
        return List.of(param.words());
    }

    /** The class of the things of the same robot whose names it has; empty for none. */
    public String getNamed() {
        return param.names() == void.class ? "" : param.names().getSimpleName();
    }

    /** Whether its text may be the name of such a thing of the same robot. */
    public boolean isNameOf(Object thing) {
        return param.names().isInstance(thing);
    }

    /** Whether what has it can't be without any value of it, or is good for nothing then. */
    public boolean isNeeded() {
        return param.required() || param.needed();
    }

    /** Whether 0 is legal, too, where the smallest number is above it. */
    public boolean isOrZero() {
        return param.orZero();
    }

    /**
     * The text of the value with which an object begins that is made with nothing but its name, where that is not the default: of a required
     * number that says none, the one nearest to 1 that is legal.
     *
     * @return empty if it begins with the default, or somebody has to say it
     */
    public String getInitial() {
        boolean number = kind == Kind.NUMBER || kind == Kind.WHOLE;
        return param.initial().isEmpty() && param.required() && number ? format(Math.max(param.min(), Math.min(param.max(), 1))) : param.initial();
    }

    /** The class of a group's parameters; for others the value's own type. */
    public Class<?> getType() {
        return type;
    }

    /** What is legal, in words: {@code 0 to 1000000 kg}. */
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

    /** Whether a single value (an entry of a list) is legal. Null is legal for an optional text, group, Double or Integer. */
    public boolean isLegal(Object value) {
        if (value == null) {
            return !param.required() && !type.isPrimitive();
        }
        switch (kind) {
            case NUMBER:
            case WHOLE:
                double number = ((Number) value).doubleValue();
                return (number >= param.min() && number <= param.max() || param.orZero() && number == 0) && isListed(format(number));
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
     * A value from its text in a file.
     *
     * @throws IllegalArgumentException if it isn't of this kind, or not legal
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
                value = trimmed;
                break;
        }
        if (!isLegal(value)) {
            throw new IllegalArgumentException(legal());
        }
        return value;
    }

    /** Java reads 1f, 0x1p3 and NaN as numbers; a file of ours has digits, sign, point and exponent only. */
    private String plainNumber(String text) {
        if (text.length() > 40 || !PLAIN_NUMBER.matcher(text).matches()) {
            throw new IllegalArgumentException(legal());
        }
        return text;
    }

    /** The value in an object: a boxed number, Boolean, String, group, List, or null. */
    public Object get(Object object) {
        try {
            return field.get(holder(object));
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Puts a value into an object without any check, as reading a file does. */
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

    /** The values in an object as a list: the entries, or the one value, or nothing if that is null. */
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
     * A value as text, as it stands in a file: {@code 0.25}, {@code 10}, {@code true}. What arithmetic with fractions leaves in the last digits is
     * left out: {@code 6 * 0.8 + 1} is 5.8, not 5.800000000000001. All else reads back as the same number.
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
