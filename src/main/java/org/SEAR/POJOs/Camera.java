// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ScriptText;

/**
 * A camera for colour, depth or infrared pictures at a fixed rate. It looks along its z axis, y is up in the picture
 * and x to the left. {@link #move} and {@link #rotate} set its pose on the robot; a servo can carry it.
 */
@Described("pictures of colours, depths or temperatures")
public class Camera extends SensorObject {
    /** Kind of a colour camera. */
    public static final String COLOR = "color";
    /** Kind of a depth camera: metres along the axis. */
    public static final String DEPTH = "depth";
    /** Kind of an infrared camera: degrees Celsius. */
    public static final String INFRARED = "infrared";
    /** Largest number of pixels, that of 1920 x 1080. A camera needs 60 bytes of memory per pixel. */
    public static final int MAX_PIXELS = 1920 * 1080;

    private static final String WHOLE_LENS = "a lens that covers the corners of the picture; these four coefficients "
        + "fold it back before them";
    private static final int LONGEST = 2048;
    /** Largest rate, Hz: one picture per simulation step. */
    private static final double FASTEST = 60;

    @Param(doc = "kind of pictures", values = {COLOR, DEPTH, INFRARED})
    private String kind = COLOR;
    @Param(doc = "pixels per row", min = 1, max = LONGEST)
    private int width = 320;
    @Param(doc = "rows; 1 for a line camera", min = 1, max = LONGEST)
    private int height = 240;
    @Param(doc = "angle between the left and the right edge, without distortion", unit = "deg", min = 0.1, max = 170)
    private double fieldOfView = 60;
    @Param(doc = "pictures a second", unit = "Hz", min = 0.001, max = FASTEST)
    private double rate = 10;
    @Param(doc = "smallest visible distance along the axis", unit = "m", min = 0.001, max = 1000)
    private double near = 0.02;
    @Param(doc = "largest visible distance along the axis", unit = "m", min = 0.01, max = 1000000)
    private double far = 10000;
    @Param(doc = "radial distortion (Brown), second power of the distance from the axis", min = -10, max = 10)
    private double k1;
    @Param(doc = "radial distortion, fourth power", min = -10, max = 10)
    private double k2;
    @Param(doc = "tangential distortion (Brown), of a lens not parallel to the image", min = -1, max = 1)
    private double p1;
    @Param(doc = "tangential distortion, horizontal", min = -1, max = 1)
    private double p2;
    @Param(doc = "column of the optical axis, 0 the middle of the leftmost; default the image's middle", unit = "px",
        min = -LONGEST, max = 2 * LONGEST)
    private Double cx;
    @Param(doc = "row of the optical axis, 0 the middle of the uppermost; default the image's middle", unit = "px",
        min = -LONGEST, max = 2 * LONGEST)
    private Double cy;
    @Param(doc = "factor on the light of colours; 1 as in the window", min = 0.001, max = 1000)
    private double exposure = 1;
    @Param(doc = "electrons of a white pixel; their shot noise is the square root of the number; 0 for none",
        unit = "e-", max = 1e9)
    private double fullWell;
    @Param(doc = "standard deviation of the read noise; needs fullWell", unit = "e-")
    private double readNoise;
    @Param(doc = "standard deviation at a depth of 1 m; grows with the square of the depth", unit = "m", max = 10)
    private double depthNoise;
    @Param(doc = "noise equivalent temperature difference: standard deviation of a temperature", unit = "K", max = 100)
    private double netd;
    @Param(doc = "whether it sees parts of its own robot")
    private boolean seesOwnRobot;

    /** For reading from a file. */
    protected Camera() {
    }

    /** Colour, 320 x 240 pixels, 60 degrees, 10 Hz, at the body's origin. */
    public Camera(String name) {
        this(name, 0, 0, 0, 0, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres. */
    public Camera(String name, double x, double y, double z) {
        this(name, x, y, z, 0, 0, 0);
    }

    /**
     * At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees; an rx of 20 tilts it 20 degrees down.
     */
    public Camera(String name, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        pose(x, y, z, rx, ry, rz);
        created(Camera.class);
    }

    @Override
    protected void crossCheck(Faults faults) {
        if ((long) width * height > MAX_PIXELS) {
            faults.add("height", height, "at most " + MAX_PIXELS + " pixels: " + MAX_PIXELS / width
                + " rows of " + width);
        }
        if (!getLens().isWhole(width, height)) {
            faults.add("k1", k1, WHOLE_LENS);
        }
        if (near >= far) {
            faults.add("near", near, "less than far, " + Parameter.format(far) + " m");
        }
        if (readNoise > 0 && fullWell == 0) {
            faults.add("readNoise", readNoise, "0 without fullWell, the electrons of a white pixel");
        }
    }

    public String getKind() {
        return kind;
    }

    /** @param newKind color (also colour), depth or infrared */
    public void setKind(String newKind) {
        String text = ScriptText.of(newKind);
        kind = checked("kind", "colour".equals(text) ? COLOR : text);
        changed();
    }

    /**
     * Sets all parameters but the pose to the data sheet values of a real camera, including its errors.
     *
     * @param name RaspberryPi-v2, C270, Kinect, D435, MLX90640 or Pixy2; case and punctuation are ignored
     * @throws IllegalArgumentException with the names of the models
     */
    public void setModel(String name) {
        checkChangeable();
        CameraModel model = CameraModel.of(ScriptText.of(name), label());
        kind = model.kind;
        width = model.width;
        height = model.height;
        fieldOfView = model.fieldOfView;
        rate = model.rate;
        near = model.near;
        far = model.far;
        fullWell = model.errors.fullWell;
        readNoise = 0;
        depthNoise = model.errors.depthNoise;
        netd = model.errors.netd;
        changed();
    }

    public int getWidth() {
        return width;
    }

    public int getHeight() {
        return height;
    }

    /**
     * Sets the size of the picture.
     *
     * @param newWidth pixels of a row, 1 to 2048
     * @param newHeight rows, 1 to 2048; 1 makes a line camera
     * @throws IllegalArgumentException for more pixels than 1920 x 1080
     */
    public void setSize(int newWidth, int newHeight) {
        int checkedWidth = checked("width", newWidth);
        int checkedHeight = checked("height", newHeight);
        if ((long) checkedWidth * checkedHeight > MAX_PIXELS) {
            throw new IllegalArgumentException(label() + ": " + newWidth + " x " + newHeight + " are "
                + (long) newWidth * newHeight + " pixels, legal: at most " + MAX_PIXELS + " (1920 x 1080)");
        }
        int oldWidth = width;
        int oldHeight = height;
        width = checkedWidth;
        height = checkedHeight;
        checkLens(() -> {
            width = oldWidth;
            height = oldHeight;
        });
        changed();
    }

    public double getFieldOfView() {
        return fieldOfView;
    }

    /** @param degrees between the left and the right edge, 0.1 to 170 */
    public void setFieldOfView(double degrees) {
        double old = fieldOfView;
        fieldOfView = checked("fieldOfView", degrees);
        checkLens(() -> fieldOfView = old);
        changed();
    }

    public double getRate() {
        return rate;
    }

    /** @param hertz pictures per simulated second, 0.001 to 60 */
    public void setRate(double hertz) {
        rate = checked("rate", hertz);
        changed();
    }

    public double getNear() {
        return near;
    }

    public double getFar() {
        return far;
    }

    /**
     * Sets the near and far limits of the picture.
     *
     * @param newNear metres along the axis, 0.001 to 1000; smaller depths are no return
     * @param newFar metres along the axis, 0.01 to 1000000, more than near
     */
    public void setRange(double newNear, double newFar) {
        double checkedNear = checked("near", newNear);
        double checkedFar = checked("far", newFar);
        if (checkedNear >= checkedFar) {
            throw new IllegalArgumentException(label() + ": near is " + Parameter.format(newNear)
                + ", legal: less than far, " + Parameter.format(newFar) + " m");
        }
        near = checkedNear;
        far = checkedFar;
        changed();
    }

    public double getK1() {
        return k1;
    }

    public double getK2() {
        return k2;
    }

    public double getP1() {
        return p1;
    }

    public double getP2() {
        return p2;
    }

    /**
     * Sets the distortion of the lens, with the coefficients and signs of OpenCV (Brown, "Decentering distortion of
     * lenses", 1966).
     *
     * @param newK1 radial, -10 to 10; below 0 a barrel, above 0 a pincushion
     * @param newK2 radial, -10 to 10
     * @param newP1 tangential, -1 to 1
     * @param newP2 tangential, -1 to 1
     */
    public void setLens(double newK1, double newK2, double newP1, double newP2) {
        double checkedK1 = checked("k1", newK1);
        double checkedK2 = checked("k2", newK2);
        double checkedP1 = checked("p1", newP1);
        double checkedP2 = checked("p2", newP2);
        double[] old = {k1, k2, p1, p2};
        bend(checkedK1, checkedK2, checkedP1, checkedP2);
        checkLens(() -> bend(old));
        changed();
    }

    private void bend(double... distortion) {
        k1 = distortion[0];
        k2 = distortion[1];
        p1 = distortion[2];
        p2 = distortion[3];
    }

    /** @param back restores the old values if the lens does not cover the whole picture */
    private void checkLens(Runnable back) {
        if (!getLens().isWhole(width, height)) {
            String message = label() + ": k1 is " + Parameter.format(k1) + ", legal: " + WHOLE_LENS;
            back.run();
            throw new IllegalArgumentException(message);
        }
    }

    public Double getCx() {
        return cx;
    }

    public Double getCy() {
        return cy;
    }

    /**
     * Sets the principal point in OpenCV's coordinates: (0, 0) is the centre of the upper left pixel.
     *
     * @param newCx column, pixels; null for the middle
     * @param newCy row, pixels; null for the middle
     */
    public void setCentre(Double newCx, Double newCy) {
        Double checkedCx = newCx == null ? null : Double.valueOf(checked("cx", newCx));
        Double checkedCy = newCy == null ? null : Double.valueOf(checked("cy", newCy));
        Double oldCx = cx;
        Double oldCy = cy;
        cx = checkedCx;
        cy = checkedCy;
        checkLens(() -> {
            cx = oldCx;
            cy = oldCy;
        });
        changed();
    }

    /** Returns the focal length, pixels. */
    public double getFocalLength() {
        return width / (2 * StrictMath.tan(StrictMath.toRadians(fieldOfView) / 2));
    }

    public BrownLens getLens() {
        double x = cx == null ? (width - 1) / 2.0 : cx;
        double y = cy == null ? (height - 1) / 2.0 : cy;
        return new BrownLens(getFocalLength(), x, y, new double[] {k1, k2, p1, p2});
    }

    public double getExposure() {
        return exposure;
    }

    /** @param factor on the light of colours, 0.001 to 1000; 1 as in the window */
    public void setExposure(double factor) {
        exposure = checked("exposure", factor);
        changed();
    }

    public double getFullWell() {
        return fullWell;
    }

    public double getReadNoise() {
        return readNoise;
    }

    /**
     * Sets the noise of colours.
     *
     * @param newFullWell electrons of a white pixel, 0 to 1e9; the noise of n electrons is their square root; 0 for
     *     none
     * @param newReadNoise standard deviation of the read noise, electrons, 0 to 1e6; 0 without fullWell
     */
    public void setShotNoise(double newFullWell, double newReadNoise) {
        double checkedWell = checked("fullWell", newFullWell);
        double checkedRead = checked("readNoise", newReadNoise);
        if (checkedRead > 0 && checkedWell == 0) {
            throw new IllegalArgumentException(label() + ": readNoise is " + Parameter.format(newReadNoise)
                + ", legal: 0 without fullWell, the electrons of a white pixel");
        }
        fullWell = checkedWell;
        readNoise = checkedRead;
        changed();
    }

    public double getDepthNoise() {
        return depthNoise;
    }

    /** @param metres standard deviation at a depth of 1 m, 0 to 10; it grows with the square of the depth */
    public void setDepthNoise(double metres) {
        depthNoise = checked("depthNoise", metres);
        changed();
    }

    public double getNetd() {
        return netd;
    }

    /** @param kelvin noise equivalent temperature difference: standard deviation of a temperature, 0 to 100 */
    public void setNetd(double kelvin) {
        netd = checked("netd", kelvin);
        changed();
    }

    public boolean isSeesOwnRobot() {
        return seesOwnRobot;
    }

    public void setSeesOwnRobot(boolean on) {
        seesOwnRobot = checked("seesOwnRobot", on);
        changed();
    }
}
