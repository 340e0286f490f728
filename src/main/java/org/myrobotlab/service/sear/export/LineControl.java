package org.myrobotlab.service.sear.export;

/**
 * Handshake, break, DTR and RTS of a line that has none of them, as command SET-CONTROL of RFC 2217 asks for and sets them: what a program has set is
 * what it is told. One thread.
 */
final class LineControl {
    /** Each group of values: the one that asks, then those that set, the first of which holds at the start; RFC 2217, section 3.1. */
    private static final int[][] GROUPS = {{0, 1, 2, 3, 17, 19}, {4, 6, 5}, {7, 8, 9}, {10, 11, 12}, {13, 14, 15, 16, 18}};
    /** No handshake, and none of its kinds is there. */
    private static final int FLOW = 0;
    private static final int INBOUND_FLOW = 4;

    private final int[] present = new int[GROUPS.length];

    LineControl() {
        for (int i = 0; i < GROUPS.length; i++) {
            present[i] = GROUPS[i][1];
        }
    }

    /**
     * Asks or sets.
     *
     * @return what holds now; for a value that the standard does not have, that there is no handshake
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
