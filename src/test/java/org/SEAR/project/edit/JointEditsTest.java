// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.Map;
import java.util.TreeMap;
import org.SEAR.POJOs.BallJoint;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.ForceTorque;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.Slider;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.script.ProjectScript;
import org.SEAR.simulator.JointAdvice;
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
    public void pagesAddChangeAndDeleteJointsAndUndoThem() throws Exception {
        door();
        Map<String, String> before = objects();
        edit("do", "add", "type", "Slider", "set", Map.of("second", "door", "x", "0.5", "rz", "90"));
        edit("do", "set", "object", "slider1", "set", Map.of("first", "frame", "lower", "0", "upper", "0.4"));
        Slider slider = (Slider) Project.read(project.folder()).getJoints().get(2);
        assertEquals("frame door 0.4", slider.getFirst() + " " + slider.getSecond() + " " + slider.getUpper());
        assertEquals(90, slider.getRz(), 0);
        edit("do", "set", "object", "slider1", "set", Map.of("first", ""));
        assertNull("the world again", Project.read(project.folder()).getJoints().get(2).getFirst());
        edit("do", "delete", "object", "slider1");
        assertEquals(2, Project.read(project.folder()).getJoints().size());
        for (int i = 0; i < 4; i++) {
            editor.undo();
        }
        assertEquals(before, objects());
    }

    @Test
    public void jointsThatCanNotMoveAreExplained() throws Exception {
        door();
        Box wall = new Box("wall", 1, 1, 1, 3);
        new Hinge("second", null, wall, 1, 0, 0);
        new Slider("rail", null, wall, 1, 0, 0).setLimits(2, 2);
        Hinge stiff = new Hinge("stiff", wall, new Box("lid", 1, 1, 1, 1), 0, 2, 0);
        stiff.setMotor(1, 90);
        stiff.setFriction(1.5);
        new FixedJoint("glue", null, new Box("shelf", 1, 1, 1, 1));
        new BallJoint("ring2", null, (Box) Project.read(project.folder()).getEnvironment().stream()
            .filter(one -> one.getName().equals("shelf")).findFirst().orElseThrow());
        Map<String, String> reasons = JointAdvice.of(Project.read(project.folder()));
        String other = " joins the same objects along or about another axis";
        assertEquals("{hinge=ring" + other + ", rail=its lower and its upper limit are both 2, "
            + "ring2=a fixed joint holds the world and shelf together, second=rail" + other
            + ", stiff=its friction, 1.5, "
            + "is not below the force of its motor at standstill, 1}", new TreeMap<>(reasons).toString());
    }

    @Test
    public void aSensorFollowsARenamedJointAndKeepsItFromBeingDeleted() throws Exception {
        door();
        Robots.rover("rover").addComponent(new ForceTorque("scale", "hinge"));
        edit("do", "rename", "object", "hinge", "name", "pivot");
        assertEquals("pivot", value("scale", "joint"));
        String said = assertThrows(ProjectException.class, () -> edit("do", "delete", "object", "pivot")).getMessage();
        assertTrue(said, said.contains("scale.xml") && said.contains("legal: the name of a joint"));
    }

    @Test
    public void gearsFollowARenamedJointAndWrongOnesAreReported() throws Exception {
        door();
        Hinge hinge = new Hinge("hinge", null, new Box("lid", 1, 1, 1, 5));
        Slider bolt = new Slider("bolt", null, new Box("pin", 1, 1, 1, 5));
        bolt.setGear(hinge, -0.01);
        edit("do", "rename", "object", "hinge", "name", "pivot");
        Slider read = (Slider) Project.read(project.folder()).getJoints().get(0);
        assertEquals("pivot -0.01", read.getGear() + " " + read.getRatio());
        String script = ProjectScript.of(Project.read(project.folder()));
        assertTrue(script, script.contains("\"gear\": \"pivot\", "));
        wrongGear("ring", "\"ring\", legal: the name of a Hinge, Slider or Rope");
        wrongGear("bolt", "another joint than itself");
        edit("do", "set", "object", "bolt", "set", Map.of("gear", "pivot"));
        String said = assertThrows(ProjectException.class,
            () -> edit("do", "set", "object", "pivot", "set", Map.of("gear", "bolt"))).getMessage();
        assertTrue(said, said.contains("a joint that does not follow this one: "));
        said = assertThrows(IllegalArgumentException.class, () -> bolt.setGear(bolt, 1)).getMessage();
        assertEquals("Slider \"bolt\": the joint that it follows is itself, legal: another Hinge, Slider or Rope",
            said);
        said = assertThrows(IllegalArgumentException.class, () -> bolt.setGear(hinge, 0)).getMessage();
        assertEquals("Slider \"bolt\": ratio is 0, legal: any number but 0", said);
        edit("do", "set", "object", "pivot", "set", Map.of("lower", "3", "upper", "3"));
        assertEquals("its gear follows pivot, which does not move",
            JointAdvice.of(Project.read(project.folder())).get("bolt"));
    }

    @Test
    public void jointsWithinARobotFollowItsParts() throws Exception {
        edit("do", "robot", "template", "rover", "name", "rover");
        for (String part : new String[] {"arm", "hand"}) {
            edit("do", "add", "type", "Box", "name", part, "to", "rover", "set", Map.of("length", 1, "width", 1,
                "height", 1));
        }
        edit("do", "add", "type", "Hinge", "name", "shoulder", "to", "rover", "set", Map.of("second", "arm"));
        edit("do", "add", "type", "Slider", "name", "wrist", "to", "rover", "set", Map.of("first", "arm", "second",
            "hand", "gear", "shoulder"));
        edit("do", "rename", "object", "rover/arm", "name", "boom");
        edit("do", "rename", "object", "shoulder", "name", "mast");
        assertEquals("boom boom mast", value("mast", "second") + " " + value("wrist", "first") + " "
            + value("wrist", "gear"));
        Project read = Project.read(project.folder());
        assertEquals("[Hinge \"mast\", Slider \"wrist\"]", read.getAllJoints().toString());
        assertTrue(read.getJoints().isEmpty());
        edit("do", "set", "object", "wrist", "set", Map.of("lower", "1", "upper", "1"));
        edit("do", "set", "object", "mast", "set", Map.of("x", "0.5"));
        edit("do", "add", "type", "Hinge", "name", "second", "to", "rover", "set", Map.of("second", "boom"));
        assertEquals("{mast=second joins the same objects along or about another axis, second=mast joins the same "
            + "objects along or about another axis, wrist=its lower and its upper limit are both 1}",
            new TreeMap<>(JointAdvice.of(Project.read(project.folder()))).toString());
        String said = assertThrows(ProjectException.class, () -> edit("do", "unmount", "object", "rover/wrist"))
            .getMessage();
        assertTrue(said, said.contains("first is \"boom\", legal: the name of an object of the environment or of a "
            + "robot; robot.addComponent(joint) makes it a joint within a robot"));
    }

    private void wrongGear(String name, String legal) {
        String said = assertThrows(ProjectException.class,
            () -> edit("do", "set", "object", "bolt", "set", Map.of("gear", name))).getMessage();
        assertTrue(said, said.contains(legal));
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
