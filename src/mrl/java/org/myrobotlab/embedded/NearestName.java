// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Comparator;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Suggests a known name for an unknown one. Any thread. */
public final class NearestName {
    /** Lowest similarity of a suggestion. */
    private static final double NEAR = 0.65;
    private static final double WITHOUT_VERB = 0.9;
    private static final int MAX_ACTIONS = 4;

    private NearestName() {
    }

    /** Returns {@code did you mean startSimulation?}; empty if no known name is similar. */
    public static String of(String wanted, Set<String> known) {
        for (String one : known) {
            if (one.equalsIgnoreCase(wanted)) {
                return question(one);
            }
        }
        String actions = known.stream().filter(one -> isVerbOf(wanted, one)).sorted().limit(MAX_ACTIONS)
            .collect(Collectors.joining(" or "));
        if (!actions.isEmpty()) {
            return question(actions);
        }
        return known.stream().filter(one -> wanted.length() > 1 && nearness(wanted, one) >= NEAR)
            .max(Comparator.comparingDouble((String one) -> nearness(wanted, one))
                .thenComparing(NearestName::likelihood).thenComparing(Comparator.reverseOrder()))
            .map(NearestName::question).orElse("");
    }

    private static String question(String name) {
        return "did you mean " + name + "?";
    }

    /** Suggests a public member of a class; members declared by the class itself come before inherited ones. */
    public static String member(String wanted, Class<?> type) {
        String own = of(wanted, members(type.getDeclaredMethods(), type.getDeclaredFields()));
        return own.isEmpty() ? of(wanted, members(type.getMethods(), type.getFields())) : own;
    }

    private static Set<String> members(Method[] methods, Field... fields) {
        Set<String> names = new TreeSet<>();
        for (Method method : methods) {
            if (Modifier.isPublic(method.getModifiers()) && !method.isSynthetic()) {
                names.add(method.getName());
            }
        }
        for (Field field : fields) {
            if (Modifier.isPublic(field.getModifiers())) {
                names.add(field.getName());
            }
        }
        return names;
    }

    /** Returns whether the name is the first word of a known one, as {@code start} of {@code startSimulation}. */
    private static boolean isVerbOf(String wanted, String known) {
        return wanted.length() > 2 && known.matches(Pattern.quote(wanted) + "[A-Z].*");
    }

    /**
     * Returns the similarity to the whole name, or at 0.9 times to the name without its first word, which users often
     * leave out.
     */
    private static double nearness(String wanted, String known) {
        String plain = wanted.toLowerCase(Locale.ROOT);
        String rest = known.replaceFirst("^[a-z]+(?=[A-Z])", "");
        double whole = similarity(plain, known.toLowerCase(Locale.ROOT));
        return rest.length() == known.length() ? whole
            : Math.max(whole, WITHOUT_VERB * similarity(plain, rest.toLowerCase(Locale.ROOT)));
    }

    /**
     * Rank among equally similar names: {@code start...} first, queries ({@code is}, {@code has}, {@code get}) last.
     */
    private static int likelihood(String name) {
        return name.matches("(is|has|get)[A-Z].*") ? 0 : name.startsWith("start") ? 2 : 1;
    }

    /** Returns twice the length of the longest common subsequence over the sum of both lengths: 1 for equal names. */
    private static double similarity(String a, String b) {
        int[] common = new int[b.length() + 1];
        for (int i = 0; i < a.length(); i++) {
            int diagonal = 0;
            for (int j = 0; j < b.length(); j++) {
                int above = common[j + 1];
                common[j + 1] = a.charAt(i) == b.charAt(j) ? diagonal + 1 : Math.max(above, common[j]);
                diagonal = above;
            }
        }
        return 2.0 * common[b.length()] / Math.max(1, a.length() + b.length());
    }
}
