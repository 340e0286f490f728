package org.myrobotlab.service.sear.netcam;

import org.SEAR.POJOs.Camera;

/** What a network camera serves. */
enum Form {
    /** JPEG files that come again and again in one answer; depths and temperatures in false colours. */
    STREAM("/stream.mjpg", null, null),
    /** The last picture, as in the stream. */
    STILL("/image.jpg", "image/jpeg", null),
    /** The same without loss: what getImage answers. */
    EXACT("/image.png", "image/png", null),
    /** Depths as 16 bits of grey. */
    DEPTHS("/depth.png", "image/png", Camera.DEPTH),
    /** Temperatures as 16 bits of grey. */
    TEMPERATURES("/temperature.png", "image/png", Camera.INFRARED),
    /** A page that shows the stream. */
    PAGE("/", "text/html; charset=utf-8", null);

    private final String path;
    private final String type;
    private final String kind;

    Form(String path, String type, String kind) {
        this.path = path;
        this.type = type;
        this.kind = kind;
    }

    /** Where it is found whatever product is imitated. */
    String getPath() {
        return path;
    }

    /** The media type. */
    String getType() {
        return type;
    }

    /** Whether it needs no more than the camera's name. */
    boolean isPage() {
        return this == PAGE;
    }

    /** Whether cameras of a kind have it. */
    boolean fits(String ofCamera) {
        return kind == null || kind.equals(ofCamera);
    }
}
