// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import com.bulletphysics.collision.broadphase.DbvtBroadphase;
import com.bulletphysics.collision.dispatch.CollisionDispatcher;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.dispatch.CollisionWorld;
import com.bulletphysics.collision.dispatch.DefaultCollisionConfiguration;
import com.bulletphysics.collision.shapes.BoxShape;
import com.bulletphysics.collision.shapes.BvhTriangleMeshShape;
import com.bulletphysics.collision.shapes.CollisionShape;
import com.bulletphysics.collision.shapes.TriangleIndexVertexArray;
import com.bulletphysics.linearmath.Transform;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import javax.vecmath.Quat4f;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Triangles;

/** A {@link BeamWorld} for jbullet's rayTest. */
final class JBulletWorld {
    private final CollisionWorld world;

    JBulletWorld(BeamWorld beams) {
        DefaultCollisionConfiguration configuration = new DefaultCollisionConfiguration();
        world = new CollisionWorld(new CollisionDispatcher(configuration), new DbvtBroadphase(), configuration);
        for (double[] b : beams.boxes) {
            Transform at = new Transform();
            at.setIdentity();
            at.setRotation(new Quat4f((float) b[6], (float) b[7], (float) b[8], (float) b[9]));
            at.origin.set((float) b[3], (float) b[4], (float) b[5]);
            add(new BoxShape(new Vector3f((float) b[0], (float) b[1], (float) b[2])), at);
        }
        if (beams.triangles != null) {
            Transform at = new Transform();
            at.setIdentity();
            add(mesh(beams.triangles), at);
        }
    }

    /** Builds jbullet's hierarchy over triangles. */
    static CollisionShape mesh(Triangles triangles) {
        ByteBuffer vertices = ByteBuffer.allocateDirect(4 * triangles.vertices.length).order(ByteOrder.nativeOrder());
        vertices.asFloatBuffer().put(triangles.vertices);
        ByteBuffer indices = ByteBuffer.allocateDirect(4 * triangles.indices.length).order(ByteOrder.nativeOrder());
        indices.asIntBuffer().put(triangles.indices);
        return new BvhTriangleMeshShape(
            new TriangleIndexVertexArray(triangles.size(), indices, 12, triangles.vertices.length / 3, vertices, 12),
            true);
    }

    private void add(CollisionShape shape, Transform at) {
        CollisionObject object = new CollisionObject();
        object.setCollisionShape(shape);
        object.setWorldTransform(at);
        world.addCollisionObject(object);
    }

    /** Returns the hit's fraction of the distance between two points; 1 without a hit. */
    float cast(Vector3f from, Vector3f to) {
        CollisionWorld.ClosestRayResultCallback result = new CollisionWorld.ClosestRayResultCallback(from, to);
        world.rayTest(from, to, result);
        return result.closestHitFraction;
    }
}
