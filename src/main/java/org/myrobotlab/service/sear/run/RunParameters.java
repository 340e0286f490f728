package org.myrobotlab.service.sear.run;

import java.math.BigInteger;
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
 * What a run of a script is asked with, and what it answers. Parameters are the system properties {@code sear.parameter.NAME}, which
 * {@code sear SCRIPT.py --set NAME=VALUE} and {@code sear sweep} set. Results are kept until whoever runs the script takes them. Any thread.
 */
public final class RunParameters {
    /** What the name of a parameter's system property begins with. */
    public static final String PROPERTY = "sear.parameter.";
    /** What a name may be. */
    public static final String LEGAL_NAME = "letters, digits and _, not a digit first, and none of row, seed, status, message, version, digest";

    private static final String SEED = "seed";
    /** Results that are kept until they are taken, and characters of a text. */
    private static final int MAX_RESULTS = 1000;
    private static final int LONGEST_TEXT = 10_000;
    private static final int MAX_BITS = 63;
    private static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");
    /** Columns of their own in the table of a sweep. */
    private static final Set<String> TAKEN = Set.of("row", SEED, "status", "message", "version", "digest");
    private static final Logger PROGRESS = LoggerFactory.getLogger("org.SEAR.progress");
    private static final Map<String, Object> RESULTS = new LinkedHashMap<>();
    /** Parameters that were given and for which a script has asked. */
    private static final Set<String> ASKED = ConcurrentHashMap.newKeySet();

    private RunParameters() {
    }

    /** Whether a parameter or a result may be called so. */
    public static boolean isLegal(String name) {
        return name != null && NAME.matcher(name).matches() && !TAKEN.contains(name);
    }

    /**
     * A parameter of this run; {@code seed} is that of the run's random numbers.
     *
     * @param standard what it is unless one was given; the one that was given has to be of the same kind
     * @throws IllegalArgumentException that names parameter, value and what is legal
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
        Object value = standard instanceof Boolean ? truth(text) : standard instanceof Number ? number(text, (Number) standard) : null;
        if (value == null) {
            throw new IllegalArgumentException("parameter " + name + " is \"" + text + "\", legal: " + legal(standard) + ", as its default "
                + standard + " is");
        }
        return value;
    }

    private static String legal(Object standard) {
        return standard instanceof Boolean ? "true or false" : !(standard instanceof Number) ? "a default that is a number, a text, True or False"
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
     * Keeps a result of this run; one of that name takes its place.
     *
     * @throws IllegalArgumentException that names result, value and what is legal
     */
    public static void setResult(String name, Object value) {
        if (!isLegal(name) || System.getProperty(PROPERTY + name) != null) {
            throw new IllegalArgumentException("result is called \"" + name + "\", legal: " + LEGAL_NAME + ", and no parameter's name");
        }
        if (value instanceof BigInteger && ((BigInteger) value).bitLength() > MAX_BITS) {
            throw new IllegalArgumentException("result " + name + " is " + value + ", legal: -2**63 to 2**63-1; float(value) keeps 15 digits of it");
        }
        Object kept = value instanceof CharSequence ? ScriptText.of(value.toString()) : value;
        if (value instanceof Number) {
            kept = isWhole((Number) value) ? (Object) ((Number) value).longValue() : (Object) ((Number) value).doubleValue();
        }
        if (!(kept instanceof String || kept instanceof Number || kept instanceof Boolean)) {
            throw new IllegalArgumentException("result " + name + " is " + value + ", legal: a number, a text, True or False");
        }
        if (kept instanceof String && ((String) kept).length() > LONGEST_TEXT) {
            throw new IllegalArgumentException("result " + name + " has " + ((String) kept).length() + " characters, legal: at most " + LONGEST_TEXT);
        }
        synchronized (RESULTS) {
            if (RESULTS.size() >= MAX_RESULTS && !RESULTS.containsKey(name)) {
                throw new IllegalArgumentException("result " + name + " is one too many, legal: at most " + MAX_RESULTS + " of a run");
            }
            RESULTS.put(name, kept);
        }
        PROGRESS.info("result: {} = {}", name, kept);
    }

    /** Parameters that were given and for which no script of this process has asked. */
    public static List<String> unasked() {
        return System.getProperties().stringPropertyNames().stream().filter(name -> name.startsWith(PROPERTY))
            .map(name -> name.substring(PROPERTY.length())).filter(name -> !ASKED.contains(name)).sorted().collect(Collectors.toList());
    }

    /** The results since this was last called, in the order in which they came. */
    public static Map<String, Object> takeResults() {
        synchronized (RESULTS) {
            Map<String, Object> taken = new LinkedHashMap<>(RESULTS);
            RESULTS.clear();
            return taken;
        }
    }
}
