// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.lang.reflect.Executable;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.myrobotlab.embedded.python.hints.SourceScan;
import org.python.core.PyBoolean;
import org.python.core.PyFloat;
import org.python.core.PyInteger;
import org.python.core.PyLong;
import org.python.core.PyObject;
import org.python.core.PyString;
import org.python.core.PyTuple;

/** Arguments of a call as written in a script line; understands literals and names. The thread that has failed. */
final class GivenValues {
    /** Package of the objects with names. */
    private static final String OBJECTS = "org.SEAR.POJOs.";
    private static final Pattern NUMBER = Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)(e[-+]?\\d+)?");
    private static final Pattern TEXT = Pattern.compile("(?i)u?(\"[^\"]*\"|'[^']*')");
    private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");
    private final List<String> values = new ArrayList<>();
    private final Scope scope;

    /** Type of an argument. */
    private enum Kind { NUMBER, TEXT, TRUTH, OTHER }

    /**
     * Reads the arguments of the first call of that name; none if the call does not end in the line.
     *
     * @param scope values of names
     */
    GivenValues(String call, String line, Scope scope) {
        this.scope = scope;
        String code = new SourceScan(List.of(line)).code(1);
        int begin = code.indexOf(call + "(");
        int depth = 0;
        int from = begin + call.length() + 1;
        for (int i = from; begin >= 0 && i < code.length() && depth >= 0; i++) {
            char c = code.charAt(i);
            depth += "([{".indexOf(c) >= 0 ? 1 : ")]}".indexOf(c) >= 0 ? -1 : 0;
            if (depth < 0 || c == ',' && depth == 0) {
                values.add(line.substring(from, i).trim());
                from = i + 1;
            }
        }
        if (depth >= 0 || values.contains("")) {
            values.clear();
        }
    }

    /**
     * Explains why an argument has the wrong type.
     *
     * @param number from 1
     * @param types the legal types
     * @return empty without an explanation
     */
    String wrong(int number, String types) {
        String written = number <= values.size() ? values.get(number - 1) : "";
        PyObject value = NAME.matcher(written).matches() ? scope.valueOf(written) : null;
        if (value == null) {
            return "";
        }
        Object object = value.__tojava__(Object.class);
        if (types.contains("String") && object != null && object.getClass().getName().startsWith(OBJECTS)) {
            return written + " is the object itself; give its name, \"" + value.invoke("getName") + "\"";
        }
        if (value instanceof PyTuple) {
            return ((PyTuple) value).__len__() == 2 ? written + " is " + value + ", two numbers: write decimals with a point, "
                + value.toString().replaceAll("[( )]", "").replace(',', '.') : written + " is " + value + ", several numbers";
        }
        return kind(written) == Kind.TEXT ? written + " is a string, " + value.__repr__() : "";
    }

    /** Returns whether the line has a decimal number with a comma. */
    boolean hasDecimalComma(String line) {
        return !values.isEmpty() && line.matches(".*[(,\\s]-?\\d+,\\d+\\s*[),].*");
    }

    /**
     * Returns the call with its arguments reordered to fit.
     *
     * @param written the call as it is written
     * @return null if no other order fits
     */
    String inOrderOf(Executable call, String written) {
        Class<?>[] types = call.getParameterTypes();
        List<String> left = new ArrayList<>(values);
        List<String> ordered = new ArrayList<>();
        for (Class<?> type : types) {
            String fit = left.stream().filter(one -> fits(type, kind(one))).findFirst().orElse(null);
            if (fit == null) {
                return null;
            }
            left.remove(fit);
            ordered.add(fit);
        }
        return left.isEmpty() && !ordered.equals(values) ? written + "(" + String.join(", ", ordered) + ")" : null;
    }

    private static boolean fits(Class<?> type, Kind kind) {
        return type == String.class ? kind == Kind.TEXT : type == boolean.class ? kind == Kind.TRUTH : type.isPrimitive() && kind == Kind.NUMBER;
    }

    private Kind kind(String written) {
        if (NUMBER.matcher(written).matches()) {
            return Kind.NUMBER;
        }
        if (TEXT.matcher(written).matches()) {
            return Kind.TEXT;
        }
        PyObject value = NAME.matcher(written).matches() ? scope.valueOf(written) : null;
        if (value instanceof PyBoolean || written.matches("True|False")) {
            return Kind.TRUTH;
        }
        return value instanceof PyInteger || value instanceof PyFloat || value instanceof PyLong ? Kind.NUMBER
            : value instanceof PyString ? Kind.TEXT : Kind.OTHER;
    }
}
