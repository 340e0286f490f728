// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.terrain;

import com.jme3.renderer.Camera;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.geometry.HeightGrid;

/**
 * Draws the ground with the tiles of {@link TileChoice}. Tiles are created when first seen and cached. Near the camera
 * they equal the field's triangles. Window thread only.
 */
public final class TerrainView {
    /** Maximum number of tiles per frame, 512 triangles each: with a graphics card, and with software rendering. */
    static final int MAX_FINE = 900;
    static final int MAX_PLAIN = 50;
    /** Maximum number of cached tiles, 3.5 kB each. */
    static final int MAX_KEPT = 2400;
    /** Distance up to which ground receives shadows, metres. */
    private static final float SHADOWS = 25;

    private final Node node = new Node("terrain");
    private final TilePyramid pyramid;
    private final TileChoice choice;
    private final TileIndices indices = new TileIndices();
    private final GroundMaterial material;
    private final Tile[][] tiles;
    private final List<Tile> kept = new ArrayList<>();
    private long picture;
    private long made;

    /** @param fine whether there is a graphics card, as in {@code Materials} */
    public TerrainView(HeightGrid field, GroundMaterial material, boolean fine) {
        this.material = material;
        pyramid = new TilePyramid(field);
        choice = new TileChoice(pyramid, fine ? MAX_FINE : MAX_PLAIN);
        tiles = new Tile[pyramid.levels][];
        for (int level = 0; level < pyramid.levels; level++) {
            tiles[level] = new Tile[pyramid.rows(level) * pyramid.columns(level)];
        }
    }

    public Node node() {
        return node;
    }

    public HeightGrid field() {
        return pyramid.field;
    }

    /** Shows the ground seen by a camera. */
    public void update(Camera camera) {
        picture++;
        choice.choose(camera);
        for (int i = 0; i < choice.count(); i++) {
            if (choice.isSeen(i)) {
                Tile tile = tile(choice.level(i), choice.row(i), choice.column(i));
                tile.stitch(indices, TileIndices.kind(choice.coarser(i, 0), choice.coarser(i, 1), choice.coarser(i, 2),
                    choice.coarser(i, 3)));
                float distance = choice.distance(i);
                tile.geometry.setMaterial(distance < SHADOWS ? material.shadowed : distance < GroundMaterial.GRAINY
                    ? material.near : material.far);
            }
        }
        for (int i = 0; i < kept.size(); i++) {
            Tile tile = kept.get(i);
            tile.geometry.setCullHint(tile.used == picture ? CullHint.Dynamic : CullHint.Always);
        }
    }

    private Tile tile(int level, int row, int column) {
        int at = row * pyramid.columns(level) + column;
        Tile tile = tiles[level][at];
        if (tile == null) {
            tile = kept.size() < MAX_KEPT ? added() : oldest();
            tile.fill(pyramid, level, row, column);
            tiles[level][at] = tile;
            made++;
        }
        tile.used = picture;
        return tile;
    }

    private Tile added() {
        Tile tile = new Tile();
        kept.add(tile);
        node.attachChild(tile.geometry);
        return tile;
    }

    /** Returns the least recently drawn tile, for reuse. */
    private Tile oldest() {
        Tile oldest = kept.get(0);
        for (int i = 1; i < kept.size(); i++) {
            oldest = kept.get(i).used < oldest.used ? kept.get(i) : oldest;
        }
        tiles[oldest.level][oldest.row * pyramid.columns(oldest.level) + oldest.column] = null;
        return oldest;
    }

    /** Returns the number of visible tiles. */
    public int seen() {
        return choice.seen();
    }

    /** Returns the number of cached tiles. */
    public int kept() {
        return kept.size();
    }

    /** Returns how many times tiles have been filled. */
    public long made() {
        return made;
    }
}
