// SPDX-License-Identifier: Apache-2.0
package org.SEAR.assets;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;

/** Draws SEAR's bundled pictures and models during the build. Deterministic. */
public final class AssetGenerator {
    private static final int SIZE = 512;

    private AssetGenerator() {
    }

    /** @param args the folder to write to */
    public static void main(String[] args) throws IOException {
        System.setProperty("java.awt.headless", "true");
        Path icons = Paths.get(args[0]).resolve("resource");
        new ProceduralPicture(Icons.SIZE, Icons.SIZE, Icons::robot).write(icons.resolve("SEAR.png"));
        new ProceduralPicture(Icons.SIZE, Icons.SIZE, Icons::scan).write(icons.resolve("LIDAR.png"));
        new ProceduralPicture(Icons.SIZE, Icons.SIZE, Icons::pin).write(icons.resolve("GPS.png"));
        Path folder = Paths.get(args[0]).resolve("org/SEAR/assets");
        Path textures = folder.resolve("textures");
        new ProceduralPicture(SIZE, SIZE, Textures::cardboard).write(textures.resolve("cardboard.png"));
        new ProceduralPicture(SIZE / 2, SIZE, Textures::cone).write(textures.resolve("cone.png"));
        new ProceduralPicture(2 * SIZE, SIZE, Textures::recycling).write(textures.resolve("recycling.png"));
        new ProceduralPicture(SIZE, SIZE, Textures::tiles).write(textures.resolve("tiles.png"));
        new ProceduralPicture(SIZE, SIZE, Textures::brick).write(textures.resolve("brick.png"));
        new ProceduralPicture(SIZE, SIZE, Textures::container).write(textures.resolve("container.png"));
        new ProceduralPicture(SIZE, SIZE, Textures::roomba).write(textures.resolve("roomba.jpg"));
        new ProceduralPicture(SIZE, SIZE / 4, Textures::tyre).write(textures.resolve("tyre.png"));
        new ProceduralPicture(SIZE, SIZE, Textures::grass).write(textures.resolve("grass.png"));
        new ProceduralPicture(2 * SIZE, 2 * SIZE, Textures::lineTrack).write(textures.resolve("line-track.png"));
        Path tree = folder.resolve("models/Tree");
        new ProceduralPicture(SIZE / 2, SIZE / 2, Textures::bark).write(tree.resolve("bark.png"));
        new ProceduralPicture(SIZE / 2, SIZE / 2, Textures::leaves).write(tree.resolve("leaves.png"));
        Files.write(tree.resolve("Tree.mesh.xml"), TreeModel.xml().getBytes(StandardCharsets.UTF_8));
        Files.write(tree.resolve("Tree.material"), TreeModel.material().getBytes(StandardCharsets.UTF_8));
    }
}
