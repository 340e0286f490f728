package org.SEAR.robot.surface;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.physics.Body;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.Solids;
import org.SEAR.project.models.Assets;

/**
 * The colour of things at a point of their surface: that of their picture, as the window shows it, else their own. A model's own textures and the
 * pictures of a terrain are not looked into: these have the colour of their object. Simulation thread.
 */
public final class SurfaceColors {
    /** Of what has no object of its own: a robot's body. */
    private static final int GREY = 0x999999;
    private static final int RGB = 0xFFFFFF;
    private static final int HEX = 16;
    private static final int CORNERS = 3;

    private final Assets assets;
    private final Consumer<String> told;
    private final Map<Body, Paint> paints = new IdentityHashMap<>();
    private final Map<String, BufferedImage> pictures = new HashMap<>();

    /** @param told hears what the user should know of pictures that can't be read, when a sensor looks at them first */
    public SurfaceColors(Assets assets, Consumer<String> told) {
        this.assets = assets;
        this.told = told;
    }

    /** A thing of the environment, of one solid. */
    public void add(Body body, Shape shape, Solid solid) {
        paints.put(body, new Paint(shape, solid));
    }

    /**
     * The colour at a point of the world that lies on a thing's surface.
     *
     * @return 0xRRGGBB
     */
    public int at(Body body, double x, double y, double z) {
        Paint paint = paints.get(body);
        if (paint == null) {
            return GREY;
        }
        Pose pose = body.getPose();
        double[] inside = pose.rotateBack(x - pose.x, y - pose.y, z - pose.z);
        return paint.at(inside);
    }

    private BufferedImage picture(String path) {
        if (!pictures.containsKey(path)) {
            pictures.put(path, read(path));
        }
        return pictures.get(path);
    }

    private BufferedImage read(String path) {
        try {
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(assets.readPicture(path)));
            if (image == null) {
                told.accept("colour and line sensors can't look at the picture " + path + ", legal: .png, .jpg, .gif or .bmp");
            }
            return image;
        } catch (IOException e) {
            told.accept("colour and line sensors can't look at a picture: " + e.getMessage());
            return null;
        }
    }

    /** What is on one thing. */
    private final class Paint {
        private final Shape shape;
        private final Solid solid;
        private final int plain;
        private boolean known;
        private BufferedImage image;
        private float[] positions;
        private float[] places;
        private int[] indices;

        Paint(Shape shape, Solid solid) {
            this.shape = shape;
            this.solid = solid;
            this.plain = Integer.parseInt(shape.getColor().substring(1), HEX);
        }

        private void learn() {
            known = true;
            SurfaceMesh look = shape.getPicture() == null ? null : Solids.look(solid, shape);
            image = look == null ? null : picture(shape.getPicture());
            if (image != null) {
                SurfaceMesh mesh = look.placed(solid.offset);
                positions = mesh.getPositions();
                places = mesh.getPictures();
                indices = mesh.getIndices();
            }
        }

        int at(double[] point) {
            if (!known) {
                learn();
            }
            if (image == null) {
                return plain;
            }
            double nearest = Double.POSITIVE_INFINITY;
            double u = 0;
            double v = 0;
            double[] weights = new double[CORNERS];
            for (int i = 0; i < indices.length; i += CORNERS) {
                double distance = Barycentric.of(positions, indices, i, point, weights);
                if (distance < nearest) {
                    nearest = distance;
                    u = mean(i, 0, weights);
                    v = mean(i, 1, weights);
                }
            }
            return pixel(u, v);
        }

        private double mean(int triangle, int coordinate, double[] weights) {
            double sum = 0;
            for (int corner = 0; corner < CORNERS; corner++) {
                sum += weights[corner] * places[2 * indices[triangle + corner] + coordinate];
            }
            return sum;
        }

        private int pixel(double u, double v) {
            int column = (int) Math.min(image.getWidth() - 1, (u - Math.floor(u)) * image.getWidth());
            int row = (int) Math.min(image.getHeight() - 1, (1 - (v - Math.floor(v))) * image.getHeight());
            return image.getRGB(column, row) & RGB;
        }
    }
}
