// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python.hints;

import java.text.Normalizer;
import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Explains characters that Python allows only in strings and comments, such as the quotation marks of word processors.
 * Any thread.
 */
public final class ForeignCharacters {
    private static final Map<Integer, String> LEGAL = legal();
    private static final Pattern WORD = Pattern.compile("[\\p{L}\\p{M}\\p{N}_]+");

    private ForeignCharacters() {
    }

    private static Map<Integer, String> legal() {
        Map<Integer, String> legal = new HashMap<>();
        put(legal, "\u201c\u201d\u201e\u201f\u00ab\u00bb", "\"");
        put(legal, "\u2018\u2019\u201a\u201b\u2039\u203a\u00b4", "'");
        put(legal, "\u2010\u2011\u2012\u2013\u2014\u2015\u2212", "-");
        put(legal, "\u00d7\u00b7\u22c5\u2217", "*");
        put(legal, "\u00f7\u2215", "/");
        put(legal, "\u2264", "<=");
        put(legal, "\u2265", ">=");
        put(legal, "\u2260", "!=");
        put(legal, "\u00b2", "**2");
        put(legal, "\u00b3", "**3");
        return legal;
    }

    private static void put(Map<Integer, String> legal, String characters, String instead) {
        characters.codePoints().forEach(point -> legal.put(point, instead));
    }

    /** Returns a sentence about the character. */
    public static String sentence(SourceScan.Place place, String line) {
        int point = place.character.codePointAt(0);
        String named = String.format("%s (U+%04X)", isSeen(point) ? place.character : "an invisible character", point);
        String instead = instead(point);
        if (!instead.isEmpty()) {
            return named + " is not allowed outside strings and comments: write " + instead;
        }
        if (isBlank(point)) {
            return named + " is not a space to Python: write an ordinary space";
        }
        String word = wordAt(line, place.column);
        return Character.isLetter(point) && !word.isEmpty() ? "the name " + word + " contains " + place.character
            + ", legal: a to z, A to Z, 0 to 9 and _" : named + " is not allowed outside strings and comments";
    }

    private static String instead(int point) {
        String plain = Normalizer.normalize(new String(Character.toChars(point)), Normalizer.Form.NFKC);
        return LEGAL.getOrDefault(point, !isBlank(point) && plain.chars().allMatch(c -> c > ' ' && c <= '~') ? plain : "");
    }

    private static boolean isBlank(int point) {
        return Character.isSpaceChar(point) || Character.isWhitespace(point) || Character.getType(point) == Character.FORMAT;
    }

    private static boolean isSeen(int point) {
        return !isBlank(point) && !Character.isISOControl(point);
    }

    private static String wordAt(String line, int column) {
        Matcher word = WORD.matcher(line);
        while (word.find()) {
            if (word.start() <= column && column < word.end()) {
                return word.group();
            }
        }
        return "";
    }
}
