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
 * Converts a Wavefront model for jMonkeyEngine's reader, which drops faces with more than four corners and supports
 * neither continued lines nor a byte order mark. Such faces are split into triangles: a convex face into a fan from its
 * first corner, any other by ear clipping (Meisters, "Polygons have ears", 1975). Invalid corner indices are reported
 * with their line.
 */
final class ObjText {
    /** Largest number of corners of a face that jMonkeyEngine supports. */
    private static final int TAKEN = 4;
    /** Largest number of corners of a non-convex face: ear clipping takes cubic time. */
    private static final int MAX_CORNERS = 100;
    /** Words of a vertex line; some programs append a colour. */
    private static final int COLORED = 4;
    private static final Pattern NUMBERS = Pattern.compile("(?:v[tn]?|f)\\s");
    private static final String MARK = "\ufeff";

    private final String name;
    private double[] at = new double[3 << 6];
    private int corners;
    /** Number of lines with texture coordinates. */
    private int pictured;
    private int normals;
    private int line;

    ObjText(String name) {
        this.name = name;
    }

    /** Returns the same model in lines that jMonkeyEngine reads completely. */
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

    /** Returns a line with its continuations. */
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

    /**
     * Returns the index of a face's corner, from 0; indices of texture coordinates and of a normal may follow: 1/2/3,
     * 1//3.
     */
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

    /** Returns the triangles of a face, as indices into its corners. */
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

    /**
     * Returns an ear: a corner whose triangle with its neighbours has the face's orientation and contains no other
     * corner.
     */
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

    /** Returns the normal of a face (Newell), with a length of twice its area. */
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

    /** Returns twice the signed area of a triangle, seen along a normal. */
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
