// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.util.List;
import org.SEAR.POJOs.Distance;
import org.junit.Rule;
import org.junit.Test;

/** Every common name of a product finds its beam, in any letter case. */
public class BeamNamesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static String beam(String name) {
        return new Distance("eye", name).getShape().getName();
    }

    @Test
    public void theNamesOfTheDissertationsTable() throws Exception {
        assertEquals("ultrasonic", beam("Ultrasonic"));
        assertEquals("infrared", beam("Infrared"));
        assertEquals("SONAR", beam("sonar"));
        assertEquals("RADAR", beam("Radar"));
        assertEquals("laser", beam("LASER"));
        assertTrue("and it is read again", Project.read(project.folder()).getRobots().isEmpty());
    }

    @Test
    public void theNamesOfProducts() {
        assertEquals("PING)))", beam("ping)))"));
        for (String name : List.of("EZ1", "ez2", "EZ3", "MaxBotix EZ4", "LV-MaxSonar-EZ2")) {
            assertEquals(name, "LV-EZ1", beam(name));
        }
        for (String name : List.of("GP2D12", "gp2y0a21yk", "GP2Y0A21YK0F")) {
            assertEquals(name, "GP2Y0A21", beam(name));
        }
    }

    @Test
    public void beamsOfTheProjectAndExactSpellingsComeFirst() throws Exception {
        String cone = "<cone><halfAngle>5</halfAngle><range>1</range></cone></Beam>";
        project.put("beams/Laser.xml", "<Beam><name>Laser</name>" + cone);
        assertEquals("Laser", beam("Laser"));
        assertEquals("laser", beam("laser"));
        assertEquals("Laser", beam("LASER"));
        try {
            beam("lasers");
            fail("no such beam");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("beam is \"lasers\", legal: ") && e.getMessage().contains("EZ4"));
        }
    }
}
