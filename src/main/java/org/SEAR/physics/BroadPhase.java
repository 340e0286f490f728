package org.SEAR.physics;

import com.bulletphysics.collision.broadphase.BroadphaseNativeType;
import com.bulletphysics.collision.broadphase.BroadphasePair;
import com.bulletphysics.collision.broadphase.BroadphaseProxy;
import com.bulletphysics.collision.broadphase.Dbvt;
import com.bulletphysics.collision.broadphase.DbvtAabbMm;
import com.bulletphysics.collision.broadphase.DbvtBroadphase;
import com.bulletphysics.collision.broadphase.DbvtProxy;
import com.bulletphysics.collision.broadphase.Dispatcher;
import com.bulletphysics.util.ObjectArrayList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.vecmath.Vector3f;

/**
 * The broad phase: which pairs of bodies may touch. It is jbullet's tree of axis-aligned bounding boxes, into which a box is put anew only when its
 * body has left it; two boxes that overlap are a pair. But only those are looked for whose boxes have changed, with stacks that are kept, and nothing
 * goes over into jbullet's second tree, of what rests: that compares all with all. Simulation thread.
 */
final class BroadPhase extends DbvtBroadphase {
    private static final int PER_CENT = 100;

    private Dbvt.Node[] left = new Dbvt.Node[64];
    private Dbvt.Node[] right = new Dbvt.Node[64];
    private int depth;
    private final List<BroadphaseProxy> changed = new ArrayList<>();

    @Override
    public BroadphaseProxy createProxy(Vector3f low, Vector3f high, BroadphaseNativeType type, Object user, short group, short mask,
            Dispatcher dispatcher, Object more) {
        BroadphaseProxy proxy = super.createProxy(low, high, type, user, group, mask, dispatcher, more);
        changed.add(proxy);
        return proxy;
    }

    @Override
    public void setAabb(BroadphaseProxy proxy, Vector3f low, Vector3f high, Dispatcher dispatcher) {
        super.setAabb(proxy, low, high, dispatcher);
        changed.add(proxy);
    }

    @Override
    public void destroyProxy(BroadphaseProxy proxy, Dispatcher dispatcher) {
        super.destroyProxy(proxy, dispatcher);
        changed.removeIf(one -> one == proxy);
    }

    @Override
    public void collide(Dispatcher dispatcher) {
        Dbvt tree = sets[DYNAMIC_SET];
        tree.optimizeIncremental(1 + tree.leaves * dupdates / PER_CENT);
        for (int i = 0; i < changed.size(); i++) {
            meet(((DbvtProxy) changed.get(i)).leaf, tree.root);
        }
        if (!changed.isEmpty()) {
            forgetParted(dispatcher);
        }
        changed.clear();
        pid++;
    }

    /** All pairs of a leaf of one tree and a leaf of another, or of the same one, whose boxes overlap. */
    private void meet(Dbvt.Node a, Dbvt.Node b) {
        depth = 0;
        if (a != null && b != null) {
            push(a, b);
        }
        while (depth > 0) {
            depth--;
            Dbvt.Node one = left[depth];
            Dbvt.Node other = right[depth];
            if (one == other) {
                if (one.isinternal()) {
                    push(one.childs[0], one.childs[0]);
                    push(one.childs[1], one.childs[1]);
                    push(one.childs[0], one.childs[1]);
                }
            } else if (DbvtAabbMm.Intersect(one.volume, other.volume)) {
                open(one, other);
            }
        }
    }

    private void open(Dbvt.Node one, Dbvt.Node other) {
        if (one.isinternal() && other.isinternal()) {
            push(one.childs[0], other.childs[0]);
            push(one.childs[1], other.childs[0]);
            push(one.childs[0], other.childs[1]);
            push(one.childs[1], other.childs[1]);
        } else if (one.isinternal()) {
            push(one.childs[0], other);
            push(one.childs[1], other);
        } else if (other.isinternal()) {
            push(one, other.childs[0]);
            push(one, other.childs[1]);
        } else {
            DbvtProxy a = (DbvtProxy) one.data;
            DbvtProxy b = (DbvtProxy) other.data;
            if (DbvtAabbMm.Intersect(a.aabb, b.aabb)) {
                paircache.addOverlappingPair(a, b);
            }
        }
    }

    private void push(Dbvt.Node one, Dbvt.Node other) {
        if (depth == left.length) {
            left = Arrays.copyOf(left, 2 * depth);
            right = Arrays.copyOf(right, 2 * depth);
        }
        left[depth] = one;
        right[depth++] = other;
    }

    /** Drops the pairs whose boxes have parted. */
    private void forgetParted(Dispatcher dispatcher) {
        ObjectArrayList<BroadphasePair> pairs = paircache.getOverlappingPairArray();
        int i = 0;
        while (i < pairs.size()) {
            BroadphasePair pair = pairs.getQuick(i);
            DbvtProxy a = (DbvtProxy) pair.pProxy0;
            DbvtProxy b = (DbvtProxy) pair.pProxy1;
            if (DbvtAabbMm.Intersect(a.aabb, b.aabb)) {
                i++;
            } else {
                paircache.removeOverlappingPair(a, b, dispatcher);
            }
        }
    }
}
