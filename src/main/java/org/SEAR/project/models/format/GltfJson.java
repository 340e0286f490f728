// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.files.FileLimits;

/** JSON of a glTF file; each error names the value's path, as {@code nodes[3].mesh}. */
final class GltfJson {
    private static final Pattern PLACE = Pattern.compile("line (\\d+) column (\\d+)");

    final String file;
    final JsonObject root;

    GltfJson(String file, byte[] json) throws IOException {
        this.file = file;
        JsonElement parsed;
        try {
            parsed = JsonParser.parseString(new String(json, StandardCharsets.UTF_8));
        } catch (JsonParseException e) {
            Matcher place = PLACE.matcher(String.valueOf(e.getMessage()));
            throw FileLimits.wrong(file, "the text " + (place.find() ? "before line " + place.group(1) + ", column "
                + place.group(2) + "," : "at its end"), "no JSON", "the JSON of a glTF 2.0 file", e);
        } catch (StackOverflowError e) {
            throw FileLimits.wrong(file, "the nesting of the JSON", "too deep", "the JSON of a glTF 2.0 file");
        }
        root = object(parsed, "the text");
    }

    static String path(String what, String name) {
        return what.isEmpty() ? name : what + "." + name;
    }

    private JsonObject object(JsonElement element, String what) throws IOException {
        if (element == null || !element.isJsonObject()) {
            throw FileLimits.wrong(file, what, element == null ? "missing" : element, "a JSON object");
        }
        return element.getAsJsonObject();
    }

    JsonObject object(JsonObject in, String what, String name) throws IOException {
        return object(in.get(name), path(what, name));
    }

    JsonObject object(JsonArray in, String what, int index) throws IOException {
        return object(in.get(index), what + "[" + index + "]");
    }

    /** Returns a list; an empty one if it is missing. */
    JsonArray list(JsonObject in, String what, String name) throws IOException {
        JsonElement element = in.get(name);
        if (element != null && !element.isJsonArray()) {
            throw FileLimits.wrong(file, path(what, name), element, "a list");
        }
        return element == null ? new JsonArray() : element.getAsJsonArray();
    }

    /** Returns a list of the file's main object. */
    JsonArray list(String name) throws IOException {
        return list(root, "", name);
    }

    /** @param missing value if there is none */
    String text(JsonObject in, String what, String name, String missing) throws IOException {
        JsonElement element = in.get(name);
        if (element != null && !(element.isJsonPrimitive() && element.getAsJsonPrimitive().isString())) {
            throw FileLimits.wrong(file, path(what, name), element, "a text");
        }
        return element == null ? missing : element.getAsString();
    }

    boolean flag(JsonObject in, String what, String name) throws IOException {
        JsonElement element = in.get(name);
        if (element != null && !(element.isJsonPrimitive() && element.getAsJsonPrimitive().isBoolean())) {
            throw FileLimits.wrong(file, path(what, name), element, "true or false");
        }
        return element != null && element.getAsBoolean();
    }

    /**
     * Returns a whole number.
     *
     * @param missing value if there is none
     */
    long whole(JsonObject in, String what, String name, long missing, long low, long high) throws IOException {
        if (!in.has(name)) {
            return missing;
        }
        double value = number(in.get(name), path(what, name));
        if (!(value >= low && value <= high) || value != Math.rint(value)) {
            throw FileLimits.wrong(file, path(what, name), in.get(name), "a whole number from " + low + " to " + high);
        }
        return (long) value;
    }

    /** Returns a finite number. */
    private double number(JsonElement element, String what) throws IOException {
        double value = Double.NaN;
        if (element.isJsonPrimitive() && element.getAsJsonPrimitive().isNumber()) {
            try {
                value = element.getAsDouble();
            } catch (NumberFormatException e) {
                value = Double.NaN;
            }
        }
        if (!Double.isFinite(value)) {
            throw FileLimits.wrong(file, what, element, "a finite number");
        }
        return value;
    }

    /** Returns an index into a list of the file's main object; -1 if it is missing. */
    int optional(JsonObject in, String what, String name, String list) throws IOException {
        return in.has(name) ? index(in.get(name), path(what, name), list(list).size()) : -1;
    }

    /** Returns an index into a list of the file's main object. */
    int reference(JsonObject in, String what, String name, String list) throws IOException {
        return index(in.get(name), path(what, name), list(list).size());
    }

    /** Returns an index into a list of so many elements. */
    int index(JsonElement element, String what, int size) throws IOException {
        String legal = size == 0 ? "nothing, because there are none" : "0 to " + (size - 1);
        if (element == null) {
            throw FileLimits.wrong(file, what, "missing", legal);
        }
        boolean number = element.isJsonPrimitive() && element.getAsJsonPrimitive().isNumber();
        double value = number ? number(element, what) : -1;
        if (!(value >= 0 && value < size) || value != Math.rint(value)) {
            throw FileLimits.wrong(file, what, element, legal);
        }
        return (int) value;
    }

    /**
     * Returns finite numbers; null if they are missing.
     *
     * @param count legal number of numbers; -1 for any
     */
    double[] numbers(JsonObject in, String what, String name, int count) throws IOException {
        if (!in.has(name)) {
            return null;
        }
        JsonArray list = list(in, what, name);
        if (count >= 0) {
            FileLimits.range(file, "the number of numbers of " + path(what, name), list.size(), count, count);
        }
        double[] numbers = new double[list.size()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = number(list.get(i), path(what, name) + "[" + i + "]");
        }
        return numbers;
    }
}
