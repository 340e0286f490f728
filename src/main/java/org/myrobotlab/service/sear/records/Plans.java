// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.records;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.grammar.ScriptText;
import org.SEAR.plan.Plan;
import org.SEAR.plan.PlanDrawing;
import org.SEAR.plot.DrawingFiles;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.run.RunSettings;
import org.myrobotlab.service.sear.run.SimulationControl;

/** Plans of the running world, or else of the project, for scripts. Any thread. */
public final class Plans {
    private final SimulationControl control;

    public Plans(SimulationControl control) {
        this.control = control;
    }

    /** Returns the text of an SVG file. */
    public String svg(boolean beams) throws InterruptedException, IOException, ProjectException {
        return DrawingFiles.svg(new PlanDrawing(plan(beams)));
    }

    /**
     * Writes a PNG or SVG file.
     *
     * @return its absolute path
     */
    public Path save(String picture) throws InterruptedException, IOException, ProjectException {
        String text = ScriptText.of(picture);
        if (text == null) {
            throw new IllegalArgumentException("the path of the picture is missing (None), legal: a text such as "
                + "\"plan.png\"");
        }
        Path file = ScriptText.path(text);
        DrawingFiles.check(file);
        DrawingFiles.save(new PlanDrawing(plan(true)), file);
        return file.toAbsolutePath().normalize();
    }

    private Plan plan(boolean beams) throws InterruptedException, IOException, ProjectException {
        Plan running = control.look((world, session) -> Plan.of(world, beams), null);
        if (running != null) {
            return running;
        }
        Path folder = control.getFolder();
        if (!Files.isDirectory(folder)) {
            throw new IOException("there is no project folder " + folder.toAbsolutePath()
                + ": create some objects first (org.SEAR.POJOs), or loadProject(\"file.sear\")");
        }
        ProjectSwap.hold();
        try (Simulation start = Simulation.load(folder, RunSettings.fromSystem().seed)) {
            return Plan.of(start, beams);
        } finally {
            ProjectSwap.letGo();
        }
    }
}
