// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.files.PrintableText;

/** The mark of one script, with reasons; its texts are safe for a terminal. Immutable. */
final class Mark {
    /** Outcome of a script. */
    enum Kind {
        PASSED("passed"), NOT_YET("not yet"), FAILED("error"), ENDLESS("endless"), TOO_LARGE("too much memory"),
            NOTHING("nothing to mark"),
        CHECK_FAILED("the check failed"), UNMARKED("not marked");

        final String words;

        Kind(String words) {
            this.words = words;
        }
    }

    final String pupil;
    final String lesson;
    final Kind kind;
    final int got;
    final int asked;
    /** Sentences about what is missing. */
    final List<String> missing;
    final Map<String, Double> measures;

    Mark(Submission of, Kind kind, int got, int asked, List<String> missing, Map<String, Double> measures) {
        pupil = PrintableText.of(of.pupil);
        lesson = of.lesson.getName();
        this.kind = kind;
        this.got = got;
        this.asked = asked;
        this.missing = missing.stream().map(PrintableText::of).collect(Collectors.toUnmodifiableList());
        this.measures = new LinkedHashMap<>(measures);
    }

    boolean isPassed() {
        return kind == Kind.PASSED;
    }
}
