// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.ContactForce;
import org.SEAR.POJOs.ForceTorque;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.Slow;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.xml.ObjectClasses;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** The bundles in examples/ equal the results of their scripts. */
@Category(Slow.class)
public class ExamplesTest {
    private static final Path EXAMPLES = Paths.get(System.getProperty("sear.root", "."), "examples");

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void eachScriptMakesItsBundle() throws Exception {
        assertEquals(13, ExampleMaker.scripts(EXAMPLES).size());
        for (Path script : ExampleMaker.scripts(EXAMPLES)) {
            ProjectSwap.delete(project.folder());
            ExampleMaker.run(script);
            Path copy = project.getRoot().toPath().resolve("bundle");
            Project example = Bundle.load(ExampleMaker.bundle(script), copy);
            assertEquals(script + ": run gradle examples", ProjectRule.files(copy), project.files());
            assertEquals(script.toString(), List.of(), example.getWarnings());
            assertEquals(script.endsWith("truck.py") ? 2 : 1, example.getRobots().size());
        }
    }

    @Test
    public void theSensorsExampleHasEverySensorButCamerasAndTwentyBoxes() throws Exception {
        Project example = Bundle.load(EXAMPLES.resolve("sensors.sear"), project.folder());
        assertEquals(20, example.getEnvironment().stream().filter(object -> object instanceof Box).count());
        Set<String> kinds = new TreeSet<>();
        for (SEARrobot robot : example.getRobots()) {
            robot.getComponents().forEach(c -> kinds.add(c.getClass().getSimpleName()));
        }
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            // the camera is in examples/ball.py, ForceTorque needs a joint, and ContactForce a load
            if (SensorObject.class.isAssignableFrom(type)
                && !Set.of(Camera.class, ForceTorque.class, ContactForce.class).contains(type)) {
                assertTrue(type.getSimpleName(), kinds.contains(type.getSimpleName()));
            }
        }
    }
}
