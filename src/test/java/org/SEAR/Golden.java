// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * Telegrams of a device from data sheets and recordings of real devices: {@code src/test/resources/golden} has a text
 * file per device. A line holds the telegram's name, an equals sign, a blank and the telegram: hexadecimal bytes, or
 * text in which {@code |} is a line feed. Lines that begin with blanks continue it. Lines that begin with {@code #}
 * name the source.
 */
public final class Golden {
    private final String device;
    private final Map<String, String> telegrams = new LinkedHashMap<>();

    private Golden(String device) {
        this.device = device;
    }

    /** Returns the telegrams of a device by the name of its file. */
    public static Golden of(String device) {
        Golden golden = new Golden(device);
        try (InputStream in = Golden.class.getResourceAsStream("/golden/" + device + ".txt")) {
            if (in == null) {
                throw new AssertionError("no src/test/resources/golden/" + device + ".txt");
            }
            golden.read(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return golden;
    }

    private void read(String text) {
        for (String line : text.replace("\n    ", " ").split("\n")) {
            if (!line.isEmpty() && !line.startsWith("#")) {
                int equals = line.indexOf(" = ");
                if (equals < 0 || telegrams.put(line.substring(0, equals), line.substring(equals + 3)) != null) {
                    throw new AssertionError(device + ".txt: no telegram, or a second one of that name: " + line);
                }
            }
        }
    }

    /** Returns the telegrams with these names, as written in the file, separated by blanks. */
    public String get(String... words) {
        return Arrays.stream(words).map(this::telegram).collect(Collectors.joining(" "));
    }

    /** Returns the telegrams with these names, one per element. */
    public String[] each(String... words) {
        return Arrays.stream(words).map(this::telegram).toArray(String[]::new);
    }

    private String telegram(String words) {
        String telegram = telegrams.get(words);
        if (telegram == null) {
            throw new AssertionError(device + ".txt has no \"" + words + "\", but "
                + new TreeSet<>(telegrams.keySet()));
        }
        return telegram;
    }

    /** Returns all telegrams by name, as written in the file. */
    public Map<String, String> all() {
        return telegrams;
    }
}
