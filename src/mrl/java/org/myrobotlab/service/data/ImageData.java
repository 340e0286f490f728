package org.myrobotlab.service.data;

/** A picture that services hand on. */
public class ImageData {
    /** The service or program that it comes from. */
    public String source;
    /** An address that a page shows. */
    public String src;
    public String encoding;
    public String name;

    public ImageData() {
    }

    public ImageData(String src) {
        this.src = src;
    }
}
