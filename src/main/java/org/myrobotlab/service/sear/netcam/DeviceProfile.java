// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.util.Arrays;
import java.util.stream.Collectors;

/** Addresses and stream boundaries of known products. */
enum DeviceProfile {
    /** Plain addresses only. */
    PLAIN("plain", 1, "picture") {
        @Override
        Form own(int door, String target) {
            return null;
        }
    },
    /**
     * Arduino's example CameraWebServer for the ESP32: stills at port 80, the stream at 81; here at a port and the next
     * one.
     */
    ESP32_CAM("ESP32-CAM", 2, "123456789000000000000987654321") {
        @Override
        Form own(int door, String target) {
            String path = target.split("\\?", 2)[0];
            return door == 0 && path.equals("/capture") ? Form.STILL : door == 1 && path.equals("/stream")
                ? Form.STREAM : null;
        }
    },
    /** mjpg-streamer (output_http) as in OctoPi, there behind /webcam. */
    OCTOPI("OctoPi", 1, "boundarydonotcross") {
        @Override
        Form own(int door, String target) {
            String[] parts = target.split("\\?", 2);
            if (parts.length < 2 || !parts[0].equals("/") && !parts[0].equals("/webcam/")) {
                return null;
            }
            String action = parts[1].split("&", 2)[0];
            return action.equals("action=stream") ? Form.STREAM : action.equals("action=snapshot") ? Form.STILL : null;
        }
    };

    private final String title;
    private final int listeners;
    private final String boundary;

    DeviceProfile(String title, int doors, String boundary) {
        this.title = title;
        this.listeners = doors;
        this.boundary = boundary;
    }

    /** @throws IllegalArgumentException with the products */
    static DeviceProfile of(String title) {
        for (DeviceProfile one : values()) {
            if (one != PLAIN && one.title.equalsIgnoreCase(title)) {
                return one;
            }
        }
        throw new IllegalArgumentException("the product is " + (title == null ? "missing (None)" : "\"" + title + "\"")
            + ", legal: " + Arrays.stream(values()).filter(one -> one != PLAIN).map(one -> one.title)
                .collect(Collectors.joining(", ")));
    }

    /** Returns the form at an address specific to this product, or null. */
    abstract Form own(int door, String target);

    /**
     * Returns the form at an address, or null.
     *
     * @param door index of the TCP port: 0 the first, 1 the next
     * @param target path and query, as in a request
     */
    Form at(int door, String target) {
        Form own = own(door, target);
        if (own != null) {
            return own;
        }
        String path = target.split("\\?", 2)[0];
        for (Form form : Form.values()) {
            if (form.getPath().equals(path)) {
                return form;
            }
        }
        return null;
    }

    /** Returns the number of consecutive TCP ports. */
    int getListeners() {
        return listeners;
    }

    /** Returns the separator of pictures in a stream. */
    String getBoundary() {
        return boundary;
    }

    String getTitle() {
        return title;
    }

    /** Returns the address of the stream in the product's usual form. */
    String stream(int port) {
        switch (this) {
            case ESP32_CAM:
                return "http://localhost:" + (port + 1) + "/stream";
            case OCTOPI:
                return "http://localhost:" + port + "/?action=stream";
            default:
                return "http://localhost:" + port + Form.STREAM.getPath();
        }
    }
}
