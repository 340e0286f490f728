// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import static org.junit.Assert.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.solid.BoxSolid;
import org.SEAR.physics.solid.Solid;
import org.junit.Test;

/** {@link StackOrder}: heights of bodies in a stack, and the order in which their contacts are solved. */
public class StackOrderTest {
    private final NarrowPhase finder = new NarrowPhase(1 / 60.0, 9.81);
    private final StackOrder levels = new StackOrder();

    private static Body body(String name, double mass) {
        Solid box = new BoxSolid(0.1, 0.1, 0.1, Pose.IDENTITY);
        Body body = new Body(name, box.perKilogram().withMass(mass), List.of(box), new Pose[] {Pose.IDENTITY},
            Pose.IDENTITY);
        body.restart();
        return body;
    }

    private PairContacts pair(Body one, Body other) {
        PairContacts pair = new PairContacts(finder);
        pair.begin(one, other);
        return pair;
    }

    private static String names(List<PairContacts> pairs) {
        return pairs.stream().map(pair -> pair.getA().name + " " + pair.getB().name).collect(Collectors.joining(", "));
    }

    @Test
    public void contactsOfATowerAreSolvedFromTheTopDown() {
        Body floor = body("floor", 0);
        Body a = body("a", 1);
        Body b = body("b", 1);
        Body c = body("c", 1);
        Body beside = body("beside", 1);
        Body flies = body("flies", 1);
        Body meets = body("meets", 1);
        List<PairContacts> pairs = new ArrayList<>(
            Arrays.asList(pair(a, floor), pair(a, b), pair(flies, meets), pair(beside, floor), pair(beside, a),
            pair(b, c)));
        assertEquals(3, levels.measure(List.of(a, b, c, beside, flies, meets), pairs));
        levels.sort(pairs);
        assertEquals("flies meets, b c, a b, a floor, beside floor, beside a", names(pairs));
    }

    @Test
    public void isolatedBodiesKeepTheirOrder() {
        Body floor = body("floor", 0);
        Body a = body("a", 1);
        Body b = body("b", 1);
        List<PairContacts> pairs = new ArrayList<>(Arrays.asList(pair(b, floor), pair(a, b), pair(a, floor)));
        assertEquals(1, levels.measure(List.of(a, b), pairs));
        levels.sort(pairs);
        assertEquals("b floor, a b, a floor", names(pairs));
    }
}
