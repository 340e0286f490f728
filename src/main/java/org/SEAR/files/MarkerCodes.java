// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Codes of ArUco and AprilTag markers: one line of hexadecimal digits per marker, one bit per cell, row by row from the
 * top left. Smaller dictionaries are the beginnings of larger ones. Any thread.
 */
final class MarkerCodes {
    private static final int HEX = 16;
    private static final Map<String, String[]> KNOWN = new ConcurrentHashMap<>();

    private MarkerCodes() {
    }

    /**
     * Returns the cells of a marker within its black edge.
     *
     * @param family the file with its codes
     * @param cells cells per row
     * @return whether each cell is white, row by row from the top left; null for an unknown marker
     */
    static boolean[] of(String family, int cells, int id) throws IOException {
        String[] codes = KNOWN.get(family);
        if (codes == null) {
            codes = read(family);
            KNOWN.put(family, codes);
        }
        if (id < 0 || id >= codes.length) {
            return null;
        }
        long code = Long.parseLong(codes[id], HEX);
        boolean[] white = new boolean[cells * cells];
        for (int i = 0; i < white.length; i++) {
            white[i] = (code >> white.length - 1 - i & 1) == 1;
        }
        return white;
    }

    private static String[] read(String family) throws IOException {
        try (InputStream in = MarkerCodes.class.getResourceAsStream("markers/" + family + ".txt")) {
            return new String(in.readAllBytes(), StandardCharsets.US_ASCII).split("\n");
        }
    }
}
