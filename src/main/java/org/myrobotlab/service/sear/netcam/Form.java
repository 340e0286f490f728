// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import org.SEAR.POJOs.Camera;

/** The resources of a network camera. */
enum Form {
    /** Continuous JPEG files in one response; depths and temperatures in false colours. */
    STREAM("/stream.mjpg", null, null),
    /** The last picture, as in the stream. */
    STILL("/image.jpg", "image/jpeg", null),
    /** The last picture without loss, as returned by getImage. */
    EXACT("/image.png", "image/png", null),
    /** Depths as 16-bit grey. */
    DEPTHS("/depth.png", "image/png", Camera.DEPTH),
    /** Temperatures as 16-bit grey. */
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

    /** Returns the path, valid for every product. */
    String getPath() {
        return path;
    }

    /** Returns the media type. */
    String getType() {
        return type;
    }

    /** Returns whether this is the page, which needs no picture. */
    boolean isPage() {
        return this == PAGE;
    }

    /** Returns whether cameras of the given kind have this form. */
    boolean fits(String ofCamera) {
        return kind == null || kind.equals(ofCamera);
    }
}
