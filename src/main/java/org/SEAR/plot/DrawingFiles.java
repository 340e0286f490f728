package org.SEAR.plot;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** Drawings as files: PNG, with the fonts that the computer has, and SVG, the same bytes everywhere. Any thread. */
public final class DrawingFiles {
    private static final String PNG = ".png";
    private static final String SVG = ".svg";

    private DrawingFiles() {
    }

    /**
     * Looks whether a picture can be saved there.
     *
     * @throws IllegalArgumentException unless it ends in .png or .svg
     */
    public static void check(Path file) {
        if (!name(file).endsWith(PNG) && !name(file).endsWith(SVG)) {
            throw new IllegalArgumentException("the picture is " + file + ", legal: a name that ends in .png or .svg");
        }
    }

    private static String name(Path file) {
        return file.getFileName() == null ? "" : file.getFileName().toString().toLowerCase(Locale.ROOT);
    }

    /**
     * Draws into a file.
     *
     * @param file of the ending .png or .svg; one of that name is replaced
     * @throws IllegalArgumentException for another ending
     * @throws IOException if it can't be written, or is a PNG and this Java has no fonts
     */
    public static void save(Drawing drawing, Path file) throws IOException {
        check(file);
        Path folder = file.toAbsolutePath().getParent();
        if (folder != null && !Files.isDirectory(folder)) {
            throw new IOException(file + " can't be written, there is no folder " + folder + ": make it first");
        }
        Files.write(file, name(file).endsWith(SVG) ? svg(drawing).getBytes(StandardCharsets.UTF_8) : png(drawing));
    }

    /** The text of an SVG file. */
    public static String svg(Drawing drawing) {
        SvgCanvas canvas = new SvgCanvas(drawing.width(), drawing.height());
        drawing.on(canvas);
        return canvas.file();
    }

    /** A Java without fonts, as one of a server may be, draws no letters. */
    private static byte[] png(Drawing drawing) throws IOException {
        PngCanvas canvas;
        try {
            canvas = new PngCanvas(drawing.width(), drawing.height());
            canvas.text("", 0, 0, Canvas.Anchor.LEFT, PlotDrawing.SIZE);
        } catch (LinkageError | RuntimeException e) {
            throw new IOException("this computer's Java has no fonts for a PNG (" + e + "): save it with the ending .svg", e);
        }
        drawing.on(canvas);
        return canvas.file();
    }
}
