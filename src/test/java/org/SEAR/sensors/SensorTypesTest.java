// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.example.OtherJar;
import org.junit.Rule;
import org.junit.Test;

/** The registry: SEAR's own sensors, and one from another jar. */
public class SensorTypesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static List<String> names() {
        return SensorTypes.load().all().stream().map(type -> type.parameterType().getSimpleName())
            .collect(Collectors.toList());
    }

    @Test
    public void theSensorsOfSearAreThere() {
        assertEquals(List.of("Accelerometer", "Bumper", "Camera", "ColorSensor", "Compass", "ContactForce", "Distance",
            "ForceTorque", "GPS", "Gyroscope", "IMU", "LIDAR", "LineSensor", "Odometer"), names());
        assertTrue(SensorTypes.load().create(new Compass("north"), 1) instanceof CompassSensor);
        assertTrue(SensorTypes.load().isSensor(new Compass("north")));
    }

    @Test
    public void unknownSensorsAreReportedWithTheKnownOnes() {
        Box box = new Box("crate", 1, 1, 1, 0);
        assertFalse(SensorTypes.load().isSensor(box));
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, () -> SensorTypes.load()
            .create(box, 1));
        assertEquals("Box crate is no sensor; sensors are Accelerometer, Bumper, Camera, ColorSensor, Compass, "
            + "ContactForce, Distance, ForceTorque, GPS, Gyroscope, IMU, LIDAR, LineSensor, Odometer", e.getMessage());
    }

    @Test
    public void everyKindIsDescribedAndItsParametersAreValidated() {
        for (SensorType type : SensorTypes.load().all()) {
            assertFalse(type.description().isEmpty());
            for (Parameter parameter : ParameterTable.of(type.parameterType()).getParameters()) {
                assertFalse(type + ": " + parameter.getName(), parameter.getDoc().isEmpty() || parameter.legal()
                    .isEmpty());
            }
        }
        ParameterTable gyroscope = ParameterTable.of(Gyroscope.class);
        assertEquals("a number from 0.01 to 10000 Hz", gyroscope.find("bandwidth").legal());
        assertEquals("60", gyroscope.defaultOf(gyroscope.find("bandwidth")));
    }

    @Test
    public void aSensorOfAnotherJarIsCreatedReadListedAndValidated() throws Exception {
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        Path folder = project.newFolder("thermometer").toPath();
        OtherJar.at(folder, "ThermometerSensor$Type");
        try (URLClassLoader jar = OtherJar.loader(folder)) {
            Thread.currentThread().setContextClassLoader(jar);
            assertTrue(names().contains("Thermometer"));

            Class<?> type = jar.loadClass("org.example.Thermometer");
            assertTrue("it does not come from the test's class path", type.getClassLoader() == jar);
            SearObject object = (SearObject) type.getConstructor(String.class).newInstance("outside");
            SEARrobot robot = new SEARrobot("robot");
            object.move(0, 2, 0);
            robot.addComponent(object);
            Sensor<?> sensor = SensorTypes.load().create(object, 1);
            assertEquals(20 - 0.0065 * 102, (Double) sensor.read(new ScriptedTruth().at(0, 100, 0, 0, 0, 0))
                .value(), 1e-12);

            String file = project.text("robot/outside.xml");
            assertTrue(file, file.contains("<Thermometer>"));
            project.put("robot/outside.xml", file.replace("<Thermometer>", "<Thermometer><ground>1000</ground>"));
            ProjectException e = assertThrows(ProjectException.class, () -> Project.read(project.folder()));
            assertTrue(e.getMessage(), e.getMessage().contains("ground") && e.getMessage()
                .contains("-100 to 100 degC"));
        } finally {
            Thread.currentThread().setContextClassLoader(before);
        }
        assertEquals(Collections.emptyList(), names().stream().filter("Thermometer"::equals)
            .collect(Collectors.toList()));
    }
}
