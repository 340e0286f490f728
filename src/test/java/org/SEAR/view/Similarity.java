// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.awt.image.BufferedImage;

/**
 * Mean structural similarity of two pictures of one size (Wang, Bovik, Sheikh and Simoncelli 2004). It compares
 * brightness in all windows of 11 x 11 pixels with Gaussian weights of 1.5 pixels standard deviation. Equal pictures
 * have 1.
 */
final class Similarity {
    private static final int REACH = 5;
    private static final double SIGMA = 1.5;
    private static final double C1 = 0.01 * 255 * 0.01 * 255;
    private static final double C2 = 0.03 * 255 * 0.03 * 255;

    private Similarity() {
    }

    static double of(BufferedImage one, BufferedImage other) {
        int width = one.getWidth();
        int height = one.getHeight();
        double[] a = grey(one);
        double[] b = grey(other);
        double[] meanA = blurred(a, width, height);
        double[] meanB = blurred(b, width, height);
        double[] squareA = blurred(product(a, a), width, height);
        double[] squareB = blurred(product(b, b), width, height);
        double[] both = blurred(product(a, b), width, height);
        double sum = 0;
        int count = 0;
        for (int row = REACH; row < height - REACH; row++) {
            for (int column = REACH; column < width - REACH; column++) {
                int i = row * width + column;
                double varianceA = squareA[i] - meanA[i] * meanA[i];
                double varianceB = squareB[i] - meanB[i] * meanB[i];
                double covariance = both[i] - meanA[i] * meanB[i];
                sum += (2 * meanA[i] * meanB[i] + C1) * (2 * covariance + C2)
                    / ((meanA[i] * meanA[i] + meanB[i] * meanB[i] + C1) * (varianceA + varianceB + C2));
                count++;
            }
        }
        return sum / count;
    }

    private static double[] grey(BufferedImage image) {
        double[] grey = new double[image.getWidth() * image.getHeight()];
        for (int i = 0; i < grey.length; i++) {
            int rgb = image.getRGB(i % image.getWidth(), i / image.getWidth());
            grey[i] = 0.299 * (rgb >> 16 & 0xff) + 0.587 * (rgb >> 8 & 0xff) + 0.114 * (rgb & 0xff);
        }
        return grey;
    }

    private static double[] product(double[] a, double[] b) {
        double[] product = new double[a.length];
        for (int i = 0; i < a.length; i++) {
            product[i] = a[i] * b[i];
        }
        return product;
    }

    /** Blurs along rows, then along columns, without pixels beyond the edge. */
    private static double[] blurred(double[] values, int width, int height) {
        return along(along(values, width, height, 1), width, height, width);
    }

    private static double[] along(double[] values, int width, int height, int step) {
        double[] blurred = new double[values.length];
        for (int i = 0; i < values.length; i++) {
            int place = step == 1 ? i % width : i / width;
            int size = step == 1 ? width : height;
            double sum = 0;
            double weights = 0;
            for (int off = -REACH; off <= REACH; off++) {
                if (place + off >= 0 && place + off < size) {
                    double weight = Math.exp(-off * off / (2 * SIGMA * SIGMA));
                    sum += weight * values[i + off * step];
                    weights += weight;
                }
            }
            blurred[i] = sum / weights;
        }
        return blurred;
    }
}
