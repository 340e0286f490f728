// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.BallJoint;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Hinge;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.script.ProjectScript;
import org.junit.Test;

/** Joints follow the names of their objects, and wrong ones are reported. */
public class JointEditsTest extends EditedProject {
    private void door() {
        Box frame = new Box("frame", 1, 1, 1);
        Box door = new Box("door", 1, 1, 1, 5);
        new Hinge("hinge", frame, door, 0.5, 0, 0);
        new BallJoint("ring", null, door, 1, 0, 0);
    }

    @Test
    public void aJointFollowsARenamedObject() throws Exception {
        door();
        edit("do", "rename", "object", "door", "name", "gate");
        Project read = Project.read(project.folder());
        assertEquals("gate", read.getJoints().get(0).getSecond());
        assertEquals("frame", read.getJoints().get(0).getFirst());
        assertEquals("gate", read.getJoints().get(1).getSecond());
    }

    @Test
    public void jointsAreDeletedWithTheirObject() throws Exception {
        door();
        Outcome outcome = edit("do", "delete", "object", "frame");
        assertEquals("hinge hinge was deleted with box frame; Undo brings back both", outcome.note);
        Project read = Project.read(project.folder());
        assertEquals("[BallJoint \"ring\"]", read.getJoints().toString());
        assertNull(read.getJoints().get(0).getFirst());
    }

    @Test
    public void aScriptOfTheProjectMakesTheJoints() throws Exception {
        door();
        String script = ProjectScript.of(Project.read(project.folder()));
        assertTrue(script, script.contains("Hinge") && script.indexOf("Hinge, {") > script.indexOf("Box(\"door\""));
    }

    @Test
    public void wrongJointsAreReported() throws Exception {
        door();
        project.put("environment/hinge.xml", project.text("environment/hinge.xml")
            .replace("<first>frame</first>", "<first>wall</first>"));
        String said = assertThrows(ProjectException.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains("\"wall\", legal: the name of an object of the environment or of a robot"));
        project.put("environment/hinge.xml", project.text("environment/hinge.xml")
            .replace("<first>wall</first>", "<first>door</first>"));
        said = assertThrows(ProjectException.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains("legal: another object than the first"));
        Box wall = new Box("wall", 1, 1, 1);
        Hinge rusty = new Hinge("hinge", null, wall);
        assertEquals("wall", rusty.getSecond());
        said = assertThrows(ProjectException.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains("connects only fixed ones, and setMass(kg) makes one movable"));
        said = assertThrows(IllegalArgumentException.class, () -> new Hinge("loose", wall, null)).getMessage();
        assertEquals("Hinge \"loose\": the second object is missing (None), legal: an object or robot; None as the "
            + "first object is the world", said);
    }
}
