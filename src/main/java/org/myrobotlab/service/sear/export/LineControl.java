// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

/**
 * Handshake, break, DTR and RTS for command SET-CONTROL of RFC 2217. The line has none of them; a query returns the
 * last value that a program has set. One thread.
 */
final class LineControl {
    /**
     * Groups of values: the query, then the values to set, of which the first is the initial one; RFC 2217, section
     * 3.1.
     */
    private static final int[][] GROUPS = {{0, 1, 2, 3, 17, 19}, {4, 6, 5}, {7, 8, 9}, {10, 11, 12},
        {13, 14, 15, 16, 18}};
    /** Index of flow control, which is always "none". */
    private static final int FLOW = 0;
    private static final int INBOUND_FLOW = 4;

    private final int[] present = new int[GROUPS.length];

    LineControl() {
        for (int i = 0; i < GROUPS.length; i++) {
            present[i] = GROUPS[i][1];
        }
    }

    /**
     * Queries or sets a value.
     *
     * @return the value in force; for an unknown value the code of no handshake
     */
    int set(int value) {
        for (int i = 0; i < GROUPS.length; i++) {
            for (int known : GROUPS[i]) {
                if (known == value) {
                    if (value != GROUPS[i][0] && i != FLOW && i != INBOUND_FLOW) {
                        present[i] = value;
                    }
                    return present[i];
                }
            }
        }
        return present[FLOW];
    }
}
