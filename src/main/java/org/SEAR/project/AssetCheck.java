// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wheel;
import org.SEAR.files.Assets;
import org.SEAR.files.UnreadablePicture;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.terrain.AerialPicture;

/** Checks that the pictures and models of objects exist: a missing picture is a warning, a missing model a problem. */
final class AssetCheck {
    private final Assets assets;
    private final ProblemList problems;
    private final List<String> warnings;
    private final Set<String> pictures = new HashSet<>();

    AssetCheck(Assets assets, ProblemList problems, List<String> warnings) {
        this.assets = assets;
        this.problems = problems;
        this.warnings = warnings;
    }

    void check(List<ParsedObject> objects) {
        for (ParsedObject parsed : objects) {
            if (parsed.object instanceof Shape) {
                checkImage(parsed, (Shape) parsed.object);
            }
            if (parsed.object instanceof SEARrobot) {
                for (Wheel wheel : ((SEARrobot) parsed.object).getWheels()) {
                    checkImage(parsed, wheel);
                }
            }
            if (parsed.object instanceof Model) {
                checkModel(parsed, ((Model) parsed.object).getPath());
            }
            if (parsed.object instanceof Terrain) {
                checkMaps(parsed, (Terrain) parsed.object);
            }
        }
    }

    private void checkImage(ParsedObject parsed, Shape shape) {
        if (shape.getImage() != null && !assets.has(shape.getImage())) {
            warnings.add(parsed.file + ": there is no picture \"" + shape.getImage() + "\" in assets; " + shape + " is shown plain");
        } else if (shape.getImage() != null && !isAerial(shape) && (shape instanceof Terrain || pictures.add(shape.getImage()))) {
            checkPicture(parsed, shape);
        }
    }

    /**
     * Reports an unreadable picture: a warning for an object, which is then shown plain; a problem for a terrain, since
     * sensors may read its aerial picture.
     */
    private void checkPicture(ParsedObject parsed, Shape shape) {
        try {
            assets.checkPicture(shape.getImage());
        } catch (IOException e) {
            if (e instanceof UnreadablePicture && !(shape instanceof Terrain)) {
                warnings.add(parsed.file + ": the picture of " + shape + " can't be shown (" + e.getMessage() + ")");
            } else {
                problems.add(parsed.file, parsed.line("image"), "image", shape.getImage(), "a picture that can be shown (" + e.getMessage() + ")");
            }
        }
    }

    /**
     * Returns whether the picture is a GeoTIFF on the terrain, which is checked with the maps, when the world is built.
     */
    private static boolean isAerial(Shape shape) {
        return shape instanceof Terrain && AerialPicture.canSayItsPlace(shape.getImage());
    }

    /** Checks that the maps exist. Their content, which may be large, is checked when the world is built. */
    private void checkMaps(ParsedObject parsed, Terrain terrain) {
        int index = 0;
        for (String path : terrain.getPaths()) {
            if (!assets.has(path)) {
                boolean first = index == 0;
                problems.add(parsed.file, parsed.line(first ? "path" : "tile#" + (index - 1)), first ? "path" : "tile", path,
                    "a file below assets, and there is none of that name: copy the elevation map to SEARproject/assets/" + path);
            }
            index++;
        }
    }

    private void checkModel(ParsedObject parsed, String path) {
        if (!ModelLoader.isModel(path)) {
            problems.add(parsed.file, parsed.line("path"), "path", path, "a model: " + String.join(", ", ModelLoader.ENDINGS));
        } else if (!assets.has(path)) {
            problems.add(parsed.file, parsed.line("path"), "path", path, "a file below assets, and there is none of that name");
        }
    }
}
