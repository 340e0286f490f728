// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;

/**
 * Pictures generated on request by path. Markers: {@code made/marker/DICT_4X4_50/7.png}. Chessboards by columns and
 * rows: {@code made/chessboard/10x7.png}. Both have a white margin, as wide as one cell of the marker or one square of
 * the board. A test card with bars of eight colours: {@code made/testcard.png}. Any thread.
 */
public final class MadePictures {
    private static final String FOLDER = "made/";
    private static final Pattern MARKER =
        Pattern.compile("made/marker/(DICT_([4-7])X[4-7]_(50|100|250|1000)|APRILTAG_36h11)/(\\d{1,4})\\.png");
    private static final Pattern CHESSBOARD = Pattern.compile("made/chessboard/(\\d{1,2})x(\\d{1,2})\\.png");
    private static final int APRILTAG_CELLS = 6;
    /** Most pixels of the longer side, about what pages show unreduced. */
    private static final int LONGEST = 512;
    /** Most pixels of a cell: a power of 2, so that smaller pictures keep its edges. */
    private static final int FINEST = 32;
    private static final int WHITE = 0xffffff;
    /**
     * White paper. Full sun and sky light of 1.32 times white makes it just white; a brighter paper would blur into
     * black edges.
     */
    private static final int PAPER = 0xc1c1c1;
    private static final String TEST_CARD = FOLDER + "testcard.png";
    private static final int[] BARS = {WHITE, 0xffff00, 0x00ffff, 0x00ff00, 0xff00ff, 0xff0000, 0x0000ff, 0};

    private MadePictures() {
    }

    /** Returns whether the picture exists. */
    static boolean isThere(String path) {
        try {
            return path.startsWith(FOLDER) && of(path) != null;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Returns a PNG file.
     *
     * @param path with forward slashes
     * @return null for any other path
     */
    public static byte[] of(String path) throws IOException {
        if (!path.startsWith(FOLDER)) {
            return null;
        }
        Matcher marker = MARKER.matcher(path);
        if (marker.matches()) {
            return marker(marker.group(1), marker.group(2), marker.group(3), Integer.parseInt(marker.group(4)));
        }
        if (path.equals(TEST_CARD)) {
            return file(2 * BARS.length, BARS.length, (column, row) -> BARS[column / 2]);
        }
        Matcher board = CHESSBOARD.matcher(path);
        return board.matches() ? chessboardFile(Integer.parseInt(board.group(1)), Integer.parseInt(board.group(2)))
            : null;
    }

    private static byte[] marker(String dictionary, String size, String count, int id) throws IOException {
        int cells = size == null ? APRILTAG_CELLS : Integer.parseInt(size);
        String family = size == null ? dictionary : "DICT_" + size + 'X' + size;
        boolean[] white = count != null && id >= Integer.parseInt(count) || !dictionary.startsWith(family) ? null
            : MarkerCodes.of(family, cells, id);
        if (white == null) {
            return null;
        }
        int side = cells + 4;
        return file(side, side, (column, row) -> {
            boolean margin = Math.min(row, column) == 0 || Math.max(row, column) == side - 1;
            boolean edge = Math.min(row, column) == 1 || Math.max(row, column) == side - 2;
            return margin || !edge && white[(row - 2) * cells + column - 2] ? PAPER : 0;
        });
    }

    /** Draws a chessboard; its top left square is black. */
    private static byte[] chessboardFile(int columns, int rows) throws IOException {
        return file(columns + 2, rows + 2, (column, row) -> {
            boolean margin = Math.min(row, column) == 0 || row > rows || column > columns;
            return margin || (row + column & 1) == 1 ? PAPER : 0;
        });
    }

    private static byte[] file(int columns, int rows, Colors colors) throws IOException {
        int size = FINEST;
        while (size > 1 && size * Math.max(columns, rows) > LONGEST) {
            size /= 2;
        }
        BufferedImage image = new BufferedImage(columns * size, rows * size, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                image.setRGB(x, y, colors.of(x / size, y / size));
            }
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        return bytes.toByteArray();
    }

    /** Colours of the cells of a picture. */
    private interface Colors {
        /** Returns 0xRRGGBB of a cell, counted from the top left. */
        int of(int column, int row);
    }
}
