// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.files.LongWork;
import org.SEAR.files.PrintableText;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.FileReasons;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.urdf.UrdfImport;
import org.myrobotlab.service.sear.files.Projects;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code sear import ROBOT.urdf}: adds a robot in URDF to the working folder's project. */
@Command(name = "import", mixinStandardHelpOptions = true,
    description = "Adds a robot in URDF to the project SEARproject of the working folder, and prints its bodies, its "
        + "joints and what SEAR leaves out.",
    footer = "Exit status: 0, or 2 if the file can't be imported.")
final class ImportCommand implements Callable<Integer> {
    private static final int PROBLEMS = 2;

    @Parameters(paramLabel = "ROBOT.urdf|ROBOT.zip", description = "A URDF, or a zip file of a URDF and its meshes; "
        + "ROBOTS.zip/PATH.urdf selects one of several.")
    private Path file;
    @Option(names = "--at", paramLabel = "X,Y,Z", description = "Place of the base: metres north, up and east. "
        + "Default: on the ground at the world's origin.")
    private String at;
    @Option(names = "--fixed", description = "Fix the base to the world.")
    private boolean fixed;
    @Option(names = "--joint", paramLabel = "NAME=POSITION", description = "Position of a joint at the start, degrees "
        + "or metres. May be given several times.")
    private Map<String, Double> positions = new LinkedHashMap<>();
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        PrintWriter out = PrintableText.writer(spec.commandLine().getOut());
        PrintWriter err = PrintableText.writer(spec.commandLine().getErr());
        Pose place = place();
        Runnable reported = LongWork.listen(err::println);
        try {
            List<String> notes = new ArrayList<>();
            String name = UrdfImport.add(file, Projects.folder(), place, fixed, positions, notes);
            notes.forEach(note -> out.println("warning: " + note));
            print(name, out);
            return ExitCode.OK;
        } catch (IOException e) {
            err.println("sear import: " + FileReasons.of(e));
        } catch (ProjectException e) {
            e.getProblems().forEach(err::println);
        } catch (IllegalArgumentException | IllegalStateException e) {
            err.println("sear import: " + e.getMessage());
        } finally {
            reported.run();
        }
        return PROBLEMS;
    }

    private Pose place() {
        if (at == null) {
            return null;
        }
        String[] words = at.split(",");
        try {
            if (words.length == 3) {
                return new Pose(Double.parseDouble(words[0]), Double.parseDouble(words[1]),
                    Double.parseDouble(words[2]), 0, 0, 0, 1);
            }
        } catch (NumberFormatException e) {
            throw wrongPlace();
        }
        throw wrongPlace();
    }

    private ParameterException wrongPlace() {
        return new ParameterException(spec.commandLine(), "--at is \"" + at + "\", legal: three numbers, such as "
            + "0,0.5,1");
    }

    private static void print(String name, PrintWriter out) throws ProjectException {
        Project project = Project.read(Projects.folder());
        List<SEARrobot> bodies = project.getRobots().stream().filter(robot -> name.equals(robot.getMachine()))
            .collect(Collectors.toList());
        out.println(name + ": " + bodies.stream().map(SEARrobot::getName).collect(Collectors.joining(", ")));
        project.getJoints().stream().filter(AxisJoint.class::isInstance)
            .filter(joint -> bodies.stream().anyMatch(body -> body.getName().equals(joint.getSecond())))
            .forEach(joint -> out.println("joint " + joint.getName() + joint((AxisJoint) joint)));
    }

    private static String joint(AxisJoint joint) {
        return (joint.getLower() == null ? "" : ", " + number(joint.getLower()) + " to " + number(joint.getUpper()))
            + (joint.getStallForce() > 0 ? ", motor of " + number(joint.getStallForce()) + ", "
            + number(joint.getNoLoadSpeed()) + " a second" : "")
            + (joint.getGear() == null ? "" : ", follows " + joint.getGear() + " by " + number(joint.getRatio()));
    }

    private static String number(double value) {
        return String.valueOf(Math.round(value * 1e4) / 1e4);
    }
}
