// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The magnetic field compared with the test values that NOAA publishes with the model. */
public class MagneticModelTest {
    private static final double PRINTED_NANOTESLA = 0.051;
    private static final double PRINTED_DEGREES = 0.00501;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();

    private static List<double[]> rows(String resource) throws IOException {
        try (BufferedReader in = new BufferedReader(
            new InputStreamReader(MagneticModelTest.class.getResourceAsStream(resource), StandardCharsets.US_ASCII))) {
            return in.lines().filter(line -> !line.startsWith("#"))
                .map(line -> java.util.Arrays.stream(line.trim().split("\\s+"))
                    .mapToDouble(Double::parseDouble).toArray())
                .collect(Collectors.toList());
        }
    }

    @Test
    public void theTwelveOfficialRowsComeOutAsPrinted() throws IOException {
        List<double[]> rows = rows("wmm2025-12-rows.txt");
        assertEquals(12, rows.size());
        for (double[] row : rows) {
            MagneticModel.Field field = MagneticModel.standard().field(row[2], row[3], row[1], row[0]);
            assertEquals(row[4], field.north, PRINTED_NANOTESLA);
            assertEquals(row[5], field.east, PRINTED_NANOTESLA);
            assertEquals(row[6], field.down, PRINTED_NANOTESLA);
            assertEquals(row[7], field.horizontal(), PRINTED_NANOTESLA);
            assertEquals(row[8], field.total(), PRINTED_NANOTESLA);
            assertEquals(row[9], field.inclination(), PRINTED_DEGREES);
            assertEquals(row[10], field.declination(), PRINTED_DEGREES);
        }
    }

    @Test
    public void theHundredRowsOfTheArchiveComeOutAsPrinted() throws IOException {
        List<double[]> rows = rows("wmm2025-100-rows.txt");
        assertEquals(100, rows.size());
        for (double[] row : rows) {
            MagneticModel.Field field = MagneticModel.standard().field(row[2], row[3], row[1], row[0]);
            assertEquals(row[4], field.declination(), PRINTED_DEGREES);
            assertEquals(row[5], field.inclination(), PRINTED_DEGREES);
            assertEquals(row[6], field.horizontal(), 0.001);
            assertEquals(row[7], field.north, 0.001);
            assertEquals(row[8], field.east, 0.001);
            assertEquals(row[9], field.down, 0.001);
            assertEquals(row[10], field.total(), 0.001);
        }
    }

    @Test
    public void thePolesHaveAFieldToo() {
        MagneticModel.Field pole = MagneticModel.standard().field(90, 0, 0, 2025);
        MagneticModel.Field near = MagneticModel.standard().field(89.999, 0, 0, 2025);
        assertEquals(near.total(), pole.total(), 1);
        assertEquals(near.declination(), pole.declination(), 0.5);
    }

    @Test
    public void itKnowsItsYears() {
        MagneticModel model = MagneticModel.standard();
        assertEquals("WMM-2025", model.getName());
        assertEquals(2025, model.getEpoch(), 0);
        assertTrue(model.covers(2025));
        assertTrue(model.covers(2030));
        assertFalse(model.covers(2024.99));
        assertFalse(model.covers(2030.01));
    }

    @Test
    public void aFileOfItsOwnReplacesTheModel() throws IOException {
        Path dipole = write("2030.0 DIPOLE 01/01/2030", "1 0 -30000.0 0.0 0.0 0.0", "9999999999");
        MagneticModel model = MagneticModel.read(dipole);
        assertEquals("DIPOLE", model.getName());
        MagneticModel.Field field = model.field(0, 17, 0, 2030);
        double expected = 30000 * Math.pow(6371.2 / 6378.137, 3);
        assertEquals(expected, field.north, 1e-6);
        assertEquals(0, field.declination(), 1e-9);
    }

    @Test
    public void brokenFilesAreNamedWithLineAndReason() throws IOException {
        String[][] cases = {
            {"1", "first line is incomplete", "2025.0"},
            {"1", "\"x\" is no number", "x WMM"},
            {"1", "\"NaN\" is not finite", "NaN WMM"},
            {"1", "no coefficients", "2025.0 WMM"},
            {"2", "5 numbers", "2025.0 WMM", "1 0 1 2 3"},
            {"2", "\"a\" is no number", "2025.0 WMM", "1 0 a 0 0 0"},
            {"3", "n, m is 1, 2", "2025.0 WMM", "1 0 1 0 0 0", "1 2 1 0 0 0"},
            {"2", "n, m is 1.5, 0", "2025.0 WMM", "1.5 0 1 0 0 0"},
            {"2", "n, m is 200, 0", "2025.0 WMM", "200 0 1 0 0 0"},
        };
        for (String[] each : cases) {
            Path file = write(java.util.Arrays.copyOfRange(each, 2, each.length));
            MagneticModel.FormatException e = assertThrows(MagneticModel.FormatException.class,
                () -> MagneticModel.read(file));
            assertEquals(each[1], e.getMessage());
            assertEquals(each[0], String.valueOf(e.getLine()));
        }
    }

    private Path write(String... lines) throws IOException {
        return Files.write(folder.newFile().toPath(), List.of(lines));
    }
}
