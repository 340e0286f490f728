// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.surface;

import java.util.function.Function;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.Solids;

/** Picture of a shape as mapped onto it, else its colour. The picture is read when a sensor first looks. */
final class ShapePaint implements SurfacePaint {
    private static final int CORNERS = 3;

    private final Shape shape;
    private final Solid solid;
    private final Function<String, SurfacePicture> pictures;
    private final int plain;
    private final double[] weights = new double[CORNERS];
    private boolean known;
    private SurfacePicture picture;
    private float[] positions;
    private float[] places;
    private int[] indices;

    /** @param pictures reads a picture; null if it can't be read */
    ShapePaint(Shape shape, Solid solid, Function<String, SurfacePicture> pictures) {
        this.shape = shape;
        this.solid = solid;
        this.pictures = pictures;
        this.plain = SurfaceColors.plain(shape);
    }

    private void learn() {
        known = true;
        SurfaceMesh look = shape.getPicture() == null ? null : Solids.look(solid, shape);
        picture = look == null ? null : pictures.apply(shape.getPicture());
        if (picture != null) {
            positions = look.getPositions();
            places = look.getPictures();
            indices = look.getIndices();
        }
    }

    @Override
    public int at(double[] point) {
        if (!known) {
            learn();
        }
        if (picture == null) {
            return plain;
        }
        double nearest = Double.POSITIVE_INFINITY;
        double u = 0;
        double v = 0;
        for (int i = 0; i < indices.length; i += CORNERS) {
            double distance = Barycentric.of(positions, indices, i, point, weights);
            if (distance < nearest) {
                nearest = distance;
                u = mean(i, 0);
                v = mean(i, 1);
            }
        }
        return picture.at(u, v);
    }

    private double mean(int triangle, int coordinate) {
        double sum = 0;
        for (int corner = 0; corner < CORNERS; corner++) {
            sum += weights[corner] * places[2 * indices[triangle + corner] + coordinate];
        }
        return sum;
    }
}
