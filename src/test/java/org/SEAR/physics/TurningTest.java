package org.SEAR.physics;

import static org.junit.Assert.assertEquals;

import com.bulletphysics.linearmath.Transform;
import com.bulletphysics.linearmath.TransformUtil;
import java.util.Random;
import javax.vecmath.Quat4f;
import javax.vecmath.Vector3f;
import org.junit.Test;

/** Where a turning body will be is worked out as jbullet does. */
public class TurningTest {
    private final Random random = new Random(7);

    private float some(double most) {
        return (float) (most * (2 * random.nextDouble() - 1));
    }

    @Test
    public void turnsToTheBitAsJbulletDoes() {
        Turning turning = new Turning();
        Transform start = new Transform();
        Transform expected = new Transform();
        Transform turned = new Transform();
        Quat4f expectedRotation = new Quat4f();
        Quat4f rotation = new Quat4f();
        for (int i = 0; i < 20000; i++) {
            double most = Math.pow(10, 6 * random.nextDouble() - 4);
            Vector3f angular = i % 50 == 0 ? new Vector3f() : new Vector3f(some(most), some(most), some(most));
            start.setRotation(i % 20 == 0 ? new Quat4f(i % 3 == 0 ? 1 : 0, i % 3 == 1 ? 1 : 0, i % 3 == 2 ? 1 : 0, 0)
                : new Quat4f(some(1), some(1), some(1), some(1)));
            start.origin.set(0, 0, 0);
            float time = 0.05f * random.nextFloat();
            TransformUtil.integrateTransform(start, new Vector3f(), angular, time, expected);
            turning.start(start.basis);
            turning.turn(angular, time, turned);
            assertEquals("number " + i, expected.basis, turned.basis);
            start.getRotation(expectedRotation);
            Turning.quaternion(start.basis, rotation);
            assertEquals("number " + i, expectedRotation, rotation);
        }
    }
}
