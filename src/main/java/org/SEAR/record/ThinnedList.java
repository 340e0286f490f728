// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Evenly thinned list of limited length: it keeps all elements, then every second, every fourth ... One thread. */
public final class ThinnedList<T> {
    private final int most;
    private final List<T> kept = new ArrayList<>();
    private long each = 1;
    private long seen;

    /** @param most maximum number of elements, 2 or more */
    public ThinnedList(int most) {
        this.most = Math.max(2, most);
    }

    /** Returns whether to {@link #add} the next element; otherwise {@link #pass} it. */
    public boolean isNextKept() {
        return seen % each == 0;
    }

    /** Skips the next element. */
    public void pass() {
        seen++;
    }

    /** Adds the next element. */
    public void add(T one) {
        if (kept.size() == most) {
            for (int i = kept.size() - 1; i > 0; i--) {
                if (i % 2 != 0) {
                    kept.remove(i);
                }
            }
            each *= 2;
        }
        if (isNextKept()) {
            kept.add(one);
        }
        seen++;
    }

    T get(int index) {
        return kept.get(index);
    }

    public Stream<T> stream() {
        return kept.stream();
    }
}
