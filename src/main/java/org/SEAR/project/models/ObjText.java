package org.SEAR.project.models;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.SEAR.files.FileLimits;

/**
 * A Wavefront model as jMonkeyEngine reads it: that leaves out faces of more than four corners, such as the end of a cylinder, and takes neither a
 * line that goes on on the next one nor a byte order mark. Such faces become triangles here: a convex one those from its first corner to the others,
 * any other by its ears (Meisters, "Polygons have ears", 1975). Numbers of corners that lead nowhere are told with their line.
 */
final class ObjText {
    /** Corners of a face that jMonkeyEngine takes. */
    private static final int TAKEN = 4;
    /** Corners of a face that is not convex: finding its ears takes a time that grows by their cube. */
    private static final int MAX_CORNERS = 100;
    /** Words of a line with a corner; behind them, some programs write its colour. */
    private static final int COLORED = 4;
    private static final Pattern NUMBERS = Pattern.compile("(?:v[tn]?|f)\\s");
    private static final String MARK = "\ufeff";

    private final String name;
    private double[] at = new double[3 << 6];
    private int corners;
    /** Lines with places in the picture. */
    private int pictured;
    private int normals;
    private int line;

    ObjText(String name) {
        this.name = name;
    }

    /** The same model in lines that jMonkeyEngine reads whole. */
    byte[] read(byte[] bytes) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream(bytes.length);
        try (BufferedReader in = new BufferedReader(new InputStreamReader(new ByteArrayInputStream(bytes), StandardCharsets.ISO_8859_1));
            Writer to = new OutputStreamWriter(out, StandardCharsets.ISO_8859_1)) {
            String mark = new String(MARK.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
            for (String text = next(in); text != null; text = next(in)) {
                write(line == 1 && text.startsWith(mark) ? text.substring(mark.length()) : text, to);
            }
        }
        return out.toByteArray();
    }

    /** A line, with those on which it goes on. */
    private String next(BufferedReader in) throws IOException {
        line++;
        String text = in.readLine();
        if (text == null || !text.endsWith("\\")) {
            return text;
        }
        StringBuilder whole = new StringBuilder();
        while (text != null && text.endsWith("\\")) {
            whole.append(text, 0, text.length() - 1).append(' ');
            text = in.readLine();
            line++;
        }
        return whole.append(text == null ? "" : text).toString();
    }

    private void write(String whole, Writer to) throws IOException {
        String text = whole;
        if (NUMBERS.matcher(whole).lookingAt() && whole.indexOf('#') > 0) {
            text = whole.substring(0, whole.indexOf('#'));
        }
        if (text.startsWith("vt")) {
            pictured++;
        } else if (text.startsWith("vn")) {
            normals++;
        } else if (text.startsWith("v ") || text.startsWith("v\t")) {
            String[] words = text.trim().split("\\s+");
            addCorner(words);
            text = words.length > COLORED ? String.join(" ", Arrays.copyOf(words, COLORED)) : text;
        } else if (text.startsWith("f ") || text.startsWith("f\t")) {
            String[] words = text.trim().split("\\s+");
            int[] face = new int[words.length - 1];
            for (int i = 0; i < face.length; i++) {
                face[i] = corner(words[i + 1]);
            }
            if (face.length > TAKEN) {
                for (int[] triangle : triangles(face)) {
                    to.write("f " + words[triangle[0] + 1] + " " + words[triangle[1] + 1] + " " + words[triangle[2] + 1] + "\n");
                }
                return;
            }
        }
        to.write(text);
        to.write('\n');
    }

    private void addCorner(String[] words) throws IOException {
        if (3 * corners == at.length) {
            at = Arrays.copyOf(at, 2 * at.length);
        }
        for (int axis = 0; axis < 3; axis++) {
            try {
                at[3 * corners + axis] = Double.parseDouble(axis + 1 < words.length ? words[axis + 1] : "");
            } catch (NumberFormatException e) {
                throw FileLimits.wrong(name, "line " + line, String.join(" ", words), "v and three numbers with decimal points");
            }
        }
        corners++;
    }

    /** The number of a face's corner, from 0; behind it may stand those of a place in the picture and of a normal: 1/2/3, 1//3. */
    private int corner(String word) throws IOException {
        String[] numbers = word.split("/", 3);
        if (numbers.length > 1 && !numbers[1].isEmpty()) {
            number(numbers[1], word, "vt", pictured);
        }
        if (numbers.length > 2 && !numbers[2].isEmpty()) {
            number(numbers[2], word, "vn", normals);
        }
        int value = number(numbers[0], word, "v", corners);
        return value > 0 ? value - 1 : corners + value;
    }

    private int number(String text, String word, String kind, int count) throws IOException {
        int value;
        try {
            value = Integer.parseInt(text);
        } catch (NumberFormatException e) {
            value = 0;
        }
        if (value == 0 || value > count || value < -count) {
            throw FileLimits.wrong(name, "a corner of the face in line " + line, word, count == 0 ? "none, for there is no " + kind
                + " line before it" : "the number of a " + kind + " line before it, 1 to " + count);
        }
        return value;
    }

    /** Places in a face of the corners of each of its triangles. */
    private List<int[]> triangles(int[] face) throws IOException {
        double[] normal = normal(face);
        List<Integer> left = new ArrayList<>();
        boolean convex = true;
        for (int i = 0; i < face.length; i++) {
            left.add(i);
            convex &= area(normal, face[i], face[(i + 1) % face.length], face[(i + 2) % face.length]) >= 0;
        }
        if (!convex && face.length > MAX_CORNERS) {
            throw FileLimits.wrong(name, "the number of corners of the face in line " + line, face.length,
                "at most " + MAX_CORNERS + " where it is not convex: export it as triangles");
        }
        List<int[]> made = new ArrayList<>();
        while (left.size() > 2) {
            int ear = convex ? 1 : ear(face, left, normal);
            int before = left.get((ear + left.size() - 1) % left.size());
            made.add(new int[] {before, left.get(ear), left.get((ear + 1) % left.size())});
            left.remove(ear);
        }
        return made;
    }

    /** A corner that can be cut off: the triangle with its neighbours turns as the face does and holds no other corner. */
    private int ear(int[] face, List<Integer> left, double[] normal) {
        int size = left.size();
        for (int i = 0; i < size; i++) {
            int a = face[left.get((i + size - 1) % size)];
            int b = face[left.get(i)];
            int c = face[left.get((i + 1) % size)];
            boolean ear = area(normal, a, b, c) > 0;
            for (int k = 2; k < size - 1 && ear; k++) {
                int p = face[left.get((i + k) % size)];
                ear = area(normal, a, b, p) < 0 || area(normal, b, c, p) < 0 || area(normal, c, a, p) < 0;
            }
            if (ear) {
                return i;
            }
        }
        return 0;
    }

    /** At right angles to a face (Newell), as long as twice its area. */
    private double[] normal(int[] face) {
        double[] n = new double[3];
        for (int i = 0; i < face.length; i++) {
            int a = 3 * face[i];
            int b = 3 * face[(i + 1) % face.length];
            for (int axis = 0; axis < 3; axis++) {
                int u = (axis + 1) % 3;
                int w = (axis + 2) % 3;
                n[axis] += (at[a + u] - at[b + u]) * (at[a + w] + at[b + w]);
            }
        }
        return n;
    }

    /** Twice the area of a triangle of corners, as seen along a normal; negative if it turns the other way. */
    private double area(double[] normal, int a, int b, int c) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            int u = (axis + 1) % 3;
            int w = (axis + 2) % 3;
            sum += normal[axis] * ((at[3 * b + u] - at[3 * a + u]) * (at[3 * c + w] - at[3 * a + w])
                - (at[3 * b + w] - at[3 * a + w]) * (at[3 * c + u] - at[3 * a + u]));
        }
        return sum;
    }
}
