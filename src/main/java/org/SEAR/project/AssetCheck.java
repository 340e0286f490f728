// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.io.InputStream;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.FloorPlan;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wheel;
import org.SEAR.files.Assets;
import org.SEAR.files.UnreadablePicture;
import org.SEAR.grammar.Parameter;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.protocol.arduino.ProgramFile;
import org.SEAR.terrain.AerialPicture;

/** Checks that the pictures and models of objects exist: a missing picture is a warning, a missing model a problem. */
final class AssetCheck {
    /** Ratio of width to height, relative to that of the picture, from which a warning is due. */
    private static final double STRETCHED = 1.02;
    private static final double MILLIMETRES = 1000;
    private static final int LARGEST_SKETCH = 16 << 20;

    private final Assets assets;
    private final ProblemList problems;
    private final List<String> warnings;
    /** Width and height of each picture, pixels; an empty array for an unreadable one. */
    private final Map<String, int[]> pictures = new HashMap<>();

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
            if (parsed.object instanceof FloorPlan) {
                checkFile(parsed, ((FloorPlan) parsed.object).getPath());
            }
            if (parsed.object instanceof Arduino && hasSketch((Arduino) parsed.object)) {
                checkSketch(parsed, (Arduino) parsed.object);
            }
            if (parsed.object instanceof Terrain) {
                checkMaps(parsed, (Terrain) parsed.object);
            }
        }
    }

    private void checkImage(ParsedObject parsed, Shape shape) {
        if (shape.getImage() != null && !assets.has(shape.getImage())) {
            warnings.add(parsed.file + ": there is no picture \"" + shape.getImage() + "\" in assets; " + shape
                + " is shown plain");
        } else if (shape.getImage() != null && !isAerial(shape)) {
            int[] size = pictures.get(shape.getImage());
            if (size == null || shape instanceof Terrain) {
                size = checkPicture(parsed, shape);
                pictures.put(shape.getImage(), size);
            }
            if (shape instanceof Floor && size.length > 0) {
                checkRatio(parsed, (Floor) shape, size);
            }
        }
    }

    /** Warns of a floor whose picture is stretched, with the size that fits. */
    private void checkRatio(ParsedObject parsed, Floor floor, int... pixels) {
        boolean repeats = floor.getPictureTile() != null;
        double length = floor.getLength() * floor.getScaleX();
        double across = repeats ? 1 : floor.getWidth() * floor.getScaleZ() / length;
        double stretched = across * pixels[1] / pixels[0];
        if (Math.max(stretched, 1 / stretched) < STRETCHED) {
            return;
        }
        String shown = String.format(Locale.ROOT, "%s: the picture %s of %s is stretched %.2f times in %s: it has %d x "
            + "%d pixels, and ",
            parsed.file, floor.getImage(), floor, Math.max(stretched, 1 / stretched), stretched > 1 ? "width"
                : "height", pixels[0], pixels[1]);
        warnings.add(shown + (repeats ? "each repetition is a square"
            : String.format(Locale.ROOT, "the floor is %s m long and %s m wide;"
            + " a width of %s m fits", Parameter.format(length), Parameter.format(across * length), Parameter.format(
            Math.round(MILLIMETRES * length * pixels[0] / pixels[1]) / MILLIMETRES))));
    }

    /**
     * Returns the size of a picture, or reports an unreadable one: a warning for an object, which is then shown plain;
     * a problem for a terrain, since sensors may read its aerial picture.
     */
    private int[] checkPicture(ParsedObject parsed, Shape shape) {
        try {
            return assets.checkPicture(shape.getImage());
        } catch (IOException e) {
            if (e instanceof UnreadablePicture && !(shape instanceof Terrain)) {
                warnings.add(parsed.file + ": the picture of " + shape + " can't be shown (" + e.getMessage() + ")");
            } else {
                problems.add(parsed.file, parsed.line("image"), "image", shape.getImage(),
                    "a picture that can be shown (" + e.getMessage() + ")");
            }
            return new int[0];
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
                problems.add(parsed.file, parsed.line(first ? "path" : "tile#" + (index - 1)), first ? "path"
                    : "tile", path, "a file below assets, and there is none of that name: copy the elevation map to "
                        + "SEARproject/assets/" + path);
            }
            index++;
        }
    }

    /** Returns whether the board can run a file of this name; the object itself reports others. */
    private static boolean hasSketch(Arduino board) {
        return board.getSketch() != null && board.getModel() != null && board.getModel().getFlash() > 0
            && ProgramFile.isNamed(board.getSketch());
    }

    private void checkSketch(ParsedObject parsed, Arduino board) {
        String path = board.getSketch();
        String legal = null;
        if (!assets.has(path)) {
            legal = "a file below assets, and there is none of that name: copy the compiled sketch to "
                + "SEARproject/assets/" + path;
        } else {
            try (InputStream in = assets.open(path)) {
                byte[] file = in.readNBytes(LARGEST_SKETCH + 1);
                if (file.length > LARGEST_SKETCH) {
                    legal = "a file of at most 16 MiB";
                } else {
                    ProgramFile.read(file, board.getModel().getFlash());
                }
            } catch (IOException | IllegalArgumentException e) {
                legal = "a sketch compiled for an Arduino Uno (" + e.getMessage() + ")";
            }
        }
        if (legal != null) {
            problems.add(parsed.file, parsed.line("sketch"), "sketch", path, legal);
        }
    }

    private void checkModel(ParsedObject parsed, String path) {
        if (!ModelLoader.isModel(path)) {
            problems.add(parsed.file, parsed.line("path"), "path", path, "a model: "
                + String.join(", ", ModelLoader.ENDINGS) + ModelLoader.CONVERT);
        } else {
            checkFile(parsed, path);
        }
    }

    private void checkFile(ParsedObject parsed, String path) {
        if (!assets.has(path)) {
            problems.add(parsed.file, parsed.line("path"), "path", path, "a file below assets, and there is none "
                + "of that name");
        }
    }
}
