// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.data;

/** An image passed between services. */
public class ImageData {
    /** The service or program that provides it. */
    public String source;
    /** Address for pages. */
    public String src;
    public String encoding;
    public String name;

    public ImageData() {
    }

    public ImageData(String src) {
        this.src = src;
    }
}
