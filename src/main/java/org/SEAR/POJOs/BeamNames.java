// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Search for the name of a beam within a longer text, such as "Sharp GP2Y0A21, left". Any thread. */
final class BeamNames {
    private BeamNames() {
    }

    /**
     * Returns the beam whose name consists of successive words of a text. Letter case and punctuation are ignored.
     *
     * @param names of the beams, aliases included
     * @return the longest such name, the first of several; null if there is none
     */
    static String in(String text, List<String> names) {
        List<String> runs = runs(text);
        return names.stream().filter(name -> runs.contains(String.join("", words(name)))).max(Comparator.comparingInt(
            (String name) -> String.join("", words(name)).length()).thenComparing(Comparator.reverseOrder()))
            .orElse(null);
    }

    private static List<String> words(String text) {
        return Stream.of(text.toLowerCase(Locale.ROOT).split("[^\\p{L}\\p{N}]+")).filter(word -> !word.isEmpty())
            .collect(Collectors.toList());
    }

    /** Returns all runs of successive words, each without spaces. */
    private static List<String> runs(String text) {
        List<String> words = words(text);
        List<String> runs = new ArrayList<>();
        for (int from = 0; from < words.size(); from++) {
            for (int to = from + 1; to <= words.size(); to++) {
                runs.add(String.join("", words.subList(from, to)));
            }
        }
        return runs;
    }
}
