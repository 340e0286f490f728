// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

import java.util.Map;
import java.util.WeakHashMap;
import org.SEAR.geometry.HeightTiles;
import org.SEAR.raycast.tree.Bvh;
import org.SEAR.raycast.tree.BvhBuilder;

/**
 * Hierarchy over {@link HeightTiles}, by which rays find the few tiles they may hit before these are loaded. The same
 * tiles share one hierarchy through a weak cache. Immutable, any thread.
 */
public final class TileTree {
    private static final Map<HeightTiles, TileTree> KNOWN = new WeakHashMap<>();

    /** Hierarchy over the tiles' boxes, rounded outward. Its items are tile numbers. */
    public final Bvh tree;

    private TileTree(HeightTiles tiles) {
        float[] boxes = new float[tiles.size() * Bvh.BOUNDS];
        for (int i = 0; i < tiles.size(); i++) {
            int at = i * Bvh.BOUNDS;
            boxes[at] = Math.nextDown(tiles.x(tiles.firstRow(i)));
            boxes[at + 1] = Math.nextDown(tiles.low(i));
            boxes[at + 2] = Math.nextDown(tiles.z(tiles.firstColumn(i)));
            boxes[at + 3] = Math.nextUp(tiles.x(tiles.lastRow(i)));
            boxes[at + 4] = Math.nextUp(tiles.high(i));
            boxes[at + 5] = Math.nextUp(tiles.z(tiles.lastColumn(i)));
        }
        tree = BvhBuilder.build(boxes, 1);
    }

    /** Returns the hierarchy over these tiles; builds it at the first call. */
    public static TileTree of(HeightTiles tiles) {
        synchronized (KNOWN) {
            return KNOWN.computeIfAbsent(tiles, TileTree::new);
        }
    }
}
