package org.SEAR.record;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** A list of things that come in order, of which at most so many are kept, evenly: all, every second, every fourth ... One thread. */
public final class ThinnedList<T> {
    private final int most;
    private final List<T> kept = new ArrayList<>();
    private long each = 1;
    private long seen;

    /** @param most 2 or more */
    public ThinnedList(int most) {
        this.most = Math.max(2, most);
    }

    /** Whether the next one is to be added; otherwise {@link #pass} it. */
    public boolean isNextKept() {
        return seen % each == 0;
    }

    /** Leaves the next one out. */
    public void pass() {
        seen++;
    }

    /** Adds the next one. */
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

    /** Those that are kept. */
    public Stream<T> stream() {
        return kept.stream();
    }
}
