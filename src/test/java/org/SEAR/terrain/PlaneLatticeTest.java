// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.terrain.format.Georeference;
import org.junit.Test;

/** The interpolated conversion from world to map, exact at a few grid points, stays near the exact one everywhere. */
public class PlaneLatticeTest {
    private static void within(double metres, String system, Georeference place, GeoOrigin origin, double size,
        double spacing) throws IOException {
        MapPlane plane = MapPlane.onEarth(origin, MapSystem.over("map", system, place.x0, place.y0), place, place.x0);
        double[] zero = new double[2];
        double[] one = new double[2];
        plane.at(0, 0, zero);
        plane.at(0, 1, one);
        double perColumn = 1 / Math.hypot(one[0] - zero[0], one[1] - zero[1]);
        plane.at(1, 0, one);
        double perRow = 1 / Math.hypot(one[0] - zero[0], one[1] - zero[1]);
        FieldGrid grid = FieldGrid.of(new double[] {size, size}, new double[] {8 * spacing, 8 * spacing},
            new double[2], true);
        PlaneLattice lattice = PlaneLattice.of(grid, plane, perColumn, perRow);
        double[] exact = new double[2];
        double[] row = new double[2 * grid.columns];
        for (int r = 0; r < grid.rows; r += 37) {
            lattice.places(r, row);
            for (int c = 0; c < grid.columns; c += 41) {
                plane.at(grid.x(r), grid.z(c), exact);
                assertEquals(0, Math.hypot((row[2 * c] - exact[0]) * perColumn, (row[2 * c + 1] - exact[1]) * perRow),
                    metres);
            }
        }
    }

    @Test
    public void aDegreeOfTheEarthWithinFiveCentimetres() throws IOException {
        within(0.05, "EPSG:4326", new Georeference("EPSG:4326", 7, 47, 1 / 3600.0, 0, 0, -1 / 3600.0),
            new GeoOrigin(46.5, 0, 7.5), 110_000, 31);
    }

    @Test
    public void inTheFarNorthToo() throws IOException {
        within(0.05, "EPSG:4326", new Georeference("EPSG:4326", 7, 80, 1 / 3600.0, 0, 0, -1 / 3600.0),
            new GeoOrigin(79.5, 0, 7.5), 110_000, 31);
    }

    @Test
    public void projected() throws IOException {
        within(0.05, "EPSG:32632", new Georeference("EPSG:32632", 300000, 5200000, 30, 0, 0, -30),
            new GeoOrigin(46.5, 0, 7.5), 110_000, 31);
    }

    @Test
    public void acrossTheDateLine() throws IOException {
        Georeference place = new Georeference("EPSG:4326", 179.5, -16, 1 / 1200.0, 0, 0, -1 / 1200.0);
        within(0.05, "EPSG:4326", place, new GeoOrigin(-16.5, 0, -179.9), 50_000, 90);
    }
}
