// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Distance;
import org.junit.Rule;
import org.junit.Test;

/** Every common name of a product finds its beam, in any letter case. */
public class BeamNamesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Rule
    public final SaidRule grammar = new SaidRule();

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
            assertTrue(e.getMessage(), e.getMessage().contains("beam is \"lasers\", legal: ") && e.getMessage()
                .contains("EZ4"));
        }
    }

    @Test
    public void aSensorGetsTheBeamThatItsNameContains() {
        for (String name : List.of("Sharp GP2Y0A21", "gp2y0a21yk-left", "GP2D12")) {
            assertEquals(name, "GP2Y0A21", new Distance(name).getShape().getName());
        }
        assertEquals("LV-EZ1-A", new Distance("front_LV-EZ1-A").getShape().getName());
        assertEquals("PING)))", new Distance("ping").getShape().getName());
        assertEquals("ultrasonic", new Distance("stopping").getShape().getName());
        assertEquals("[Distance \"Sharp GP2Y0A21\" gets the beam GP2Y0A21 of its name: Distance(name, beam) "
            + "chooses another,"
            + " Distance \"gp2y0a21yk-left\" gets the beam GP2Y0A21YK of its name: Distance(name, beam) "
            + "chooses another,"
            + " Distance \"front_LV-EZ1-A\" gets the beam LV-EZ1-A of its name: Distance(name, beam) chooses another,"
            + " Distance \"ping\" gets the beam PING of its name: Distance(name, beam) chooses another,"
            + " Distance \"stopping\" gets the beam ultrasonic, as its name contains no beam's: Distance(name, beam) "
            + "chooses another]", grammar.said.toString());
    }

    @Test
    public void aBeamMayBeGivenInALongerText() {
        Distance eye = new Distance("eye", "Sharp GP2Y0A02YK0F (infrared)");
        assertEquals("GP2Y0A02YK0F", eye.getBeam());
        eye.setBeam("HC SR04");
        assertEquals("HC-SR04", eye.getBeam());
        eye.set(Map.of("beam", "Parallax PING"));
        assertEquals("Parallax PING)))", eye.getBeam());
        assertEquals("[Distance \"eye\": beam \"Sharp GP2Y0A02YK0F (infrared)\" is taken as GP2Y0A02YK0F,"
            + " Distance \"eye\": beam \"HC SR04\" is taken as HC-SR04, Distance \"eye\": beam \"Parallax PING\" is "
            + "taken as Parallax PING)))]", grammar.said.toString());
    }
}
