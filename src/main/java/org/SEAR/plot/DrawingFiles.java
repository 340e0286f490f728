// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.SEAR.files.AtomicFile;

/**
 * Writes drawings to files: PNG, with the computer's fonts, or SVG, with the same bytes on every computer. Any thread.
 */
public final class DrawingFiles {
    private static final String PNG = ".png";
    private static final String SVG = ".svg";

    private DrawingFiles() {
    }

    /**
     * Checks the file's ending.
     *
     * @throws IllegalArgumentException unless it is .png or .svg
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
     * Draws to a file.
     *
     * @param file ends in .png or .svg; replaced if it exists
     * @throws IllegalArgumentException for another ending
     * @throws IOException if it cannot be written, or for a PNG if this Java has no fonts
     */
    public static void save(Drawing drawing, Path file) throws IOException {
        check(file);
        Path folder = file.toAbsolutePath().getParent();
        if (folder != null && !Files.isDirectory(folder)) {
            throw new IOException(file + " can't be written, there is no folder " + folder + ": make it first");
        }
        AtomicFile.write(file, name(file).endsWith(SVG) ? svg(drawing).getBytes(StandardCharsets.UTF_8) : png(drawing));
    }

    /** Returns the text of an SVG file. */
    public static String svg(Drawing drawing) {
        SvgCanvas canvas = new SvgCanvas(drawing.width(), drawing.height());
        drawing.on(canvas);
        return canvas.file();
    }

    /** Throws if this Java has no fonts, as on some servers. */
    private static byte[] png(Drawing drawing) throws IOException {
        PngCanvas canvas;
        try {
            canvas = new PngCanvas(drawing.width(), drawing.height());
            canvas.text("", 0, 0, Canvas.Anchor.LEFT, PlotDrawing.SIZE);
        } catch (LinkageError | RuntimeException e) {
            throw new IOException("this computer's Java has no fonts for a PNG (" + e
                + "): save it with the ending .svg", e);
        }
        drawing.on(canvas);
        return canvas.file();
    }
}
