// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.math.BigInteger;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.SEAR.grammar.ScriptText;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Parameters and results of a run. Parameters are the system properties {@code sear.parameter.NAME}, set by
 * {@code sear SCRIPT.py --set NAME=VALUE} and {@code sear sweep}. Results are stored until the program that runs the
 * script takes them. Any thread.
 */
public final class RunParameters {
    /** Prefix of the system properties of parameters. */
    public static final String PROPERTY = "sear.parameter.";
    /** Rule for names of parameters and results. */
    public static final String LEGAL_NAME = "letters, digits and _, not a digit first, and none of row, seed, status, "
        + "message, version, digest";

    private static final String SEED = "seed";
    /** Most results stored until they are taken, and most characters of a text. */
    private static final int MAX_RESULTS = 1000;
    private static final int LONGEST_TEXT = 10_000;
    private static final int MAX_BITS = 63;
    private static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");
    /** Reserved columns in the table of a sweep. */
    private static final Set<String> TAKEN = Set.of("row", SEED, "status", "message", "version", "digest");
    private static final Logger PROGRESS = LoggerFactory.getLogger("org.SEAR.progress");
    private static final Map<String, Object> RESULTS = new LinkedHashMap<>();
    /** Names of given parameters that a script has read. */
    private static final Set<String> ASKED = ConcurrentHashMap.newKeySet();

    private RunParameters() {
    }

    /** Returns whether the name is legal for a parameter or result. */
    public static boolean isLegal(String name) {
        return name != null && NAME.matcher(name).matches() && !TAKEN.contains(name);
    }

    /**
     * Returns a parameter of this run; {@code seed} is the seed of its random numbers.
     *
     * @param standard default value; a given value must be of the same type
     * @throws IllegalArgumentException with parameter, value and legal values
     */
    public static Object get(String name, Object standard) {
        boolean isSeed = SEED.equals(name);
        if (!isSeed && !isLegal(name)) {
            throw new IllegalArgumentException("parameter is called \"" + name + "\", legal: " + LEGAL_NAME);
        }
        String text = System.getProperty(isSeed ? "sear.seed" : PROPERTY + name);
        if (text != null) {
            ASKED.add(name);
        }
        if (text == null || standard == null || standard instanceof CharSequence) {
            return text == null ? standard instanceof String ? ScriptText.of((String) standard) : standard : text;
        }
        Object value = standard instanceof Boolean ? truth(text) : standard instanceof Number
            ? number(text, (Number) standard) : null;
        if (value == null) {
            throw new IllegalArgumentException("parameter " + name + " is \"" + text + "\", legal: " + legal(standard)
                + ", as its default "
                + standard + " is");
        }
        return value;
    }

    private static String legal(Object standard) {
        return standard instanceof Boolean ? "true or false" : !(standard instanceof Number)
            ? "a default that is a number, a text, True or False"
            : isWhole((Number) standard) ? "a whole number" : "a number";
    }

    private static Object truth(String text) {
        return text.equalsIgnoreCase("true") ? Boolean.TRUE : text.equalsIgnoreCase("false") ? Boolean.FALSE : null;
    }

    private static boolean isWhole(Number number) {
        return !(number instanceof Double || number instanceof Float || number instanceof java.math.BigDecimal);
    }

    private static Object number(String text, Number standard) {
        try {
            if (!isWhole(standard)) {
                return Double.valueOf(text);
            }
            long whole = Long.parseLong(text);
            return whole == (int) whole ? (Object) (int) whole : (Object) whole;
        } catch (NumberFormatException e) {
            return null;
        }
    }

    /**
     * Stores a result of this run; replaces one of the same name.
     *
     * @throws IllegalArgumentException with result, value and legal values
     */
    public static void setResult(String name, Object value) {
        if (!isLegal(name) || System.getProperty(PROPERTY + name) != null) {
            throw new IllegalArgumentException("result is called \"" + name + "\", legal: " + LEGAL_NAME
                + ", and no parameter's name");
        }
        if (value instanceof BigInteger && ((BigInteger) value).bitLength() > MAX_BITS) {
            throw new IllegalArgumentException("result " + name + " is " + value + ", legal: -2**63 to 2**63-1; "
                + "float(value) keeps 15 digits of it");
        }
        Object kept = value instanceof CharSequence ? ScriptText.of(value.toString()) : value;
        if (value instanceof Number) {
            kept = isWhole((Number) value) ? (Object) ((Number) value).longValue() : (Object) ((Number) value)
                .doubleValue();
        }
        if (!(kept instanceof String || kept instanceof Number || kept instanceof Boolean)) {
            boolean several = value instanceof Collection || value != null && value.getClass().isArray();
            throw new IllegalArgumentException("result " + name + " is " + (several ? "a list" : value)
                + ", legal: a number, a text, True or False" + (several ? "; give each value a name, such as"
                + " sear.setResult(\"" + name + "_0\", values[0])" : ""));
        }
        if (kept instanceof String && ((String) kept).length() > LONGEST_TEXT) {
            throw new IllegalArgumentException("result " + name + " has " + ((String) kept).length()
                + " characters, legal: at most " + LONGEST_TEXT);
        }
        synchronized (RESULTS) {
            if (RESULTS.size() >= MAX_RESULTS && !RESULTS.containsKey(name)) {
                throw new IllegalArgumentException("result " + name + " is one too many, legal: at most " + MAX_RESULTS
                    + " per run");
            }
            RESULTS.put(name, kept);
        }
        PROGRESS.info("result: {} = {}", name, kept);
    }

    /** Returns the names of given parameters that no script of this process has read. */
    public static List<String> unasked() {
        return System.getProperties().stringPropertyNames().stream().filter(name -> name.startsWith(PROPERTY))
            .map(name -> name.substring(PROPERTY.length())).filter(name -> !ASKED.contains(name)).sorted()
            .collect(Collectors.toList());
    }

    /** Removes and returns the results, oldest first. */
    public static Map<String, Object> takeResults() {
        synchronized (RESULTS) {
            Map<String, Object> taken = new LinkedHashMap<>(RESULTS);
            RESULTS.clear();
            return taken;
        }
    }
}
