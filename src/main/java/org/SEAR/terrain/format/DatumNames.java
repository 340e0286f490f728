// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Geographic systems of the EPSG register by the names of their datums in well-known text. Source: datums.txt. */
final class DatumNames {
    private static final String FILE = "datums.txt";
    private static final Pattern DATUM = Pattern.compile("DATUM\\[\"([^\"]*)\"", Pattern.CASE_INSENSITIVE);

    private static final Pattern MERIDIAN = Pattern.compile("PRIMEM\\[\"([^\"]*)\"", Pattern.CASE_INSENSITIVE);

    private DatumNames() {
    }

    /**
     * Returns the geographic system of a text's datum.
     *
     * @param text well-known text by ESRI or OGC
     * @return EPSG:NUMBER of a system in degrees from Greenwich; null for an unknown datum
     */
    static String system(String text) throws IOException {
        Matcher datum = DATUM.matcher(text);
        Matcher meridian = MERIDIAN.matcher(text);
        String name = datum.find() ? plain(datum.group(1)) : "";
        Map<String, String> all = all();
        // the same datum with longitudes from another meridian, as Nouvelle_Triangulation_Francaise_(Paris)
        String number = all.get(all.containsKey(name) || !meridian.find() ? name
            : name.replaceFirst("_" + Pattern.quote(plain(meridian.group(1))) + "$", ""));
        return number == null ? null : "EPSG:" + number;
    }

    private static String plain(String name) {
        return name.toLowerCase(Locale.ROOT).replaceFirst("^d_", "").replaceAll("[^a-z0-9+]+", "_")
            .replaceAll("^_|_$", "");
    }

    private static Map<String, String> all() throws IOException {
        Map<String, String> numbers = new HashMap<>();
        try (InputStream in = DatumNames.class.getResourceAsStream(FILE)) {
            for (String line : new String(in.readAllBytes(), StandardCharsets.UTF_8).split("\n")) {
                if (!line.startsWith("#")) {
                    int space = line.indexOf(' ');
                    numbers.put(line.substring(0, space), line.substring(space + 1));
                }
            }
        }
        return numbers;
    }
}
