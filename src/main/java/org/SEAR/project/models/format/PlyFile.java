// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.files.FileLimits;

/** Header of a PLY file, its elements with their properties in the order of the data, and the numbers of the data. */
final class PlyFile {
    /** Bytes of a number by the name of its type. */
    private static final Map<String, Type> TYPES = new HashMap<>();
    private static final int MAX_LINES = 10_000;

    static {
        type(new Type(1, true, false), "char", "int8");
        type(new Type(1, false, false), "uchar", "uint8");
        type(new Type(2, true, false), "short", "int16");
        type(new Type(2, false, false), "ushort", "uint16");
        type(new Type(4, true, false), "int", "int32");
        type(new Type(4, false, false), "uint", "uint32");
        type(new Type(4, true, true), "float", "float32");
        type(new Type(8, true, true), "double", "float64");
    }

    /** Type of a number. */
    static final class Type {
        final int bytes;
        final boolean signed;
        final boolean real;

        private Type(int bytes, boolean signed, boolean real) {
            this.bytes = bytes;
            this.signed = signed;
            this.real = real;
        }
    }

    /** Property of an element: a number, or a list of numbers after their number. */
    static final class Property {
        final String name;
        final Type type;
        /** Type of the number of a list's entries; null for a single number. */
        final Type counter;

        private Property(String name, Type type, Type counter) {
            this.name = name;
            this.type = type;
            this.counter = counter;
        }
    }

    /** Rows of equal properties. */
    static final class Element {
        final String name;
        final long count;
        final List<Property> properties = new ArrayList<>();

        private Element(String name, long count) {
            this.name = name;
            this.count = count;
        }

        /** Returns the position of the first property with one of these names; -1 for none. */
        int index(String... names) {
            for (int i = 0; i < properties.size(); i++) {
                for (String each : names) {
                    if (properties.get(i).name.equals(each)) {
                        return i;
                    }
                }
            }
            return -1;
        }
    }

    final List<Element> elements = new ArrayList<>();
    /** Byte order of binary data; null for text. */
    ByteOrder order;
    /** Picture that a comment names, as MeshLab writes; null for none. */
    String picture;
    /** Element and row being read, in errors. */
    String element;
    long row;
    private final String name;
    private final byte[] bytes;
    private final ByteBuffer in;
    private int data;
    private int line;
    private String text;

    PlyFile(String name, byte[] bytes) throws IOException {
        this.name = name;
        this.bytes = bytes;
        require(next() != null && text.equals("ply"), "ply");
        String[] format = next() == null ? new String[0] : text.split("\\s+");
        require(format.length == 3 && format[0].equals("format") && format[2].equals("1.0"), "format and its version, "
            + "as format ascii 1.0");
        require(format[1].matches("ascii|binary_little_endian|binary_big_endian"), "format ascii, "
            + "binary_little_endian or binary_big_endian");
        order = format[1].equals("ascii") ? null : format[1].equals("binary_big_endian") ? ByteOrder.BIG_ENDIAN
            : ByteOrder.LITTLE_ENDIAN;
        while (next() != null && !text.equals("end_header")) {
            add(text.split("\\s+"));
        }
        require(text != null, "end_header at the end of the head");
        line++;
        in = ByteBuffer.wrap(bytes);
        in.position(Math.min(bytes.length, data));
        if (order != null) {
            in.order(order);
        }
    }

    private static void type(Type type, String... names) {
        for (String name : names) {
            TYPES.put(name, type);
        }
    }

    private void require(boolean right, String legal) throws IOException {
        if (!right) {
            throw FileLimits.wrong(name, "line " + line + " of the head", text == null ? "missing" : text, legal);
        }
    }

    /** Goes to the next line; returns null at the end of the file. */
    private String next() throws IOException {
        line++;
        FileLimits.range(name, "the number of lines of the head", line, 1, MAX_LINES);
        int end = data;
        while (end < bytes.length && bytes[end] != '\n' && bytes[end] != '\r') {
            end++;
        }
        FileLimits.range(name, "the number of characters of line " + line, end - data, 0, ModelLimits.MAX_LINE);
        text = end >= bytes.length ? null : new String(bytes, data, end - data, StandardCharsets.UTF_8).trim();
        data = end + (end + 1 < bytes.length && bytes[end] == '\r' && bytes[end + 1] == '\n' ? 2 : 1);
        return text;
    }

    private void add(String[] words) throws IOException {
        switch (words[0]) {
            case "comment":
                picture = words.length > 2 && words[1].toLowerCase(Locale.ROOT).equals("texturefile")
                    ? text.split("\\s+", 3)[2] : picture;
                break;
            case "obj_info":
                break;
            case "element":
                require(words.length == 3 && words[2].matches("\\d{1,10}"), "element, its name and its number");
                elements.add(new Element(words[1], Long.parseLong(words[2])));
                break;
            case "property":
                property(words);
                break;
            default:
                require(false, "element, property, comment, obj_info or end_header");
        }
    }

    private void property(String[] words) throws IOException {
        require(!elements.isEmpty(), "an element before its properties");
        boolean list = words.length == 5 && words[1].equals("list");
        Type counter = list ? TYPES.get(words[2]) : null;
        Type type = TYPES.get(words.length < 3 ? "" : words[list ? 3 : 1]);
        require((list || words.length == 3) && type != null && (!list || counter != null && !counter.real),
            "property, a type and a name, or property list, two types and a name; types are char, uchar, short, "
            + "ushort, int, uint, float, double");
        elements.get(elements.size() - 1).properties.add(new Property(words[words.length - 1], type, counter));
    }

    /** Throws if the file has fewer bytes than the rows of an element need at least: memory follows the file's size. */
    void requireBytes(Element of) throws IOException {
        long least = 0;
        for (Property property : of.properties) {
            least += order == null ? 2 : property.counter == null ? property.type.bytes : property.counter.bytes;
        }
        if (of.count * least - 1 > in.remaining()) {
            throw FileLimits.wrong(name, "the number of rows of element " + of.name, of.count,
                "those that the file has: it is cut off");
        }
    }

    /** Goes to the next line of text: rows end with their line, and MeshLab writes numbers that its head lacks. */
    void endRow() {
        int end = in.position();
        while (order == null && end < bytes.length && bytes[end] != '\n' && bytes[end] != '\r') {
            end++;
        }
        in.position(end);
    }

    /** Returns the row that is being read, as {@code face 7}. */
    String where() {
        return element + " " + (row + 1);
    }

    /** Returns the next number. */
    double number(Type type) throws IOException {
        if (order == null) {
            return word(type);
        }
        try {
            if (type.real) {
                return type.bytes == 4 ? in.getFloat() : in.getDouble();
            }
            switch (type.bytes) {
                case 1:
                    return type.signed ? in.get() : in.get() & 0xff;
                case 2:
                    return type.signed ? in.getShort() : in.getShort() & 0xffff;
                default:
                    return type.signed ? in.getInt() : Integer.toUnsignedLong(in.getInt());
            }
        } catch (BufferUnderflowException e) {
            throw FileLimits.wrong(name, where(), "missing", "all elements that the head states: the file is cut off",
                e);
        }
    }

    private double word(Type type) throws IOException {
        while (in.hasRemaining() && bytes[in.position()] <= ' ' && bytes[in.position()] >= 0) {
            line += in.get() == '\n' ? 1 : 0;
        }
        int start = in.position();
        int end = start;
        while (end < bytes.length && (bytes[end] > ' ' || bytes[end] < 0)) {
            end++;
        }
        in.position(end);
        String word = new String(bytes, start, end - start, StandardCharsets.ISO_8859_1);
        if (word.isEmpty()) {
            throw FileLimits.wrong(name, where(), "missing", "all elements that the head states: the file is cut off");
        }
        try {
            return type.real ? Double.parseDouble(word) : Long.parseLong(word);
        } catch (NumberFormatException e) {
            throw FileLimits.wrong(name, "a number of " + where() + " in line " + line, word,
                type.real ? "a number with a decimal point" : "a whole number", e);
        }
    }
}
