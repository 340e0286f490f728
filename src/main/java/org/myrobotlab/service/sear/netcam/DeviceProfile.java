package org.myrobotlab.service.sear.netcam;

import java.util.Arrays;
import java.util.stream.Collectors;

/** Products whose addresses programs know, and what separates the pictures of their streams. */
enum DeviceProfile {
    /** Plain addresses only. */
    PLAIN("plain", 1, "picture") {
        @Override
        Form own(int door, String target) {
            return null;
        }
    },
    /** The example CameraWebServer of Arduino's core for the ESP32: stills at port 80, the stream at 81; here at a port and the next one. */
    ESP32_CAM("ESP32-CAM", 2, "123456789000000000000987654321") {
        @Override
        Form own(int door, String target) {
            String path = target.split("\\?", 2)[0];
            return door == 0 && path.equals("/capture") ? Form.STILL : door == 1 && path.equals("/stream") ? Form.STREAM : null;
        }
    },
    /** mjpg-streamer (output_http), which OctoPi has, there behind /webcam. */
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

    /** @throws IllegalArgumentException that lists the products */
    static DeviceProfile of(String title) {
        for (DeviceProfile one : values()) {
            if (one != PLAIN && one.title.equalsIgnoreCase(title)) {
                return one;
            }
        }
        throw new IllegalArgumentException("the product is " + (title == null ? "missing (None)" : "\"" + title + "\"") + ", legal: "
            + Arrays.stream(values()).filter(one -> one != PLAIN).map(one -> one.title).collect(Collectors.joining(", ")));
    }

    /** What only this product has at an address; null for nothing. */
    abstract Form own(int door, String target);

    /**
     * What stands at an address; null for nothing.
     *
     * @param door the first port, 0, or the one after it, 1
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

    /** TCP ports that it listens at, one after the other. */
    int getListeners() {
        return listeners;
    }

    /** What separates the pictures of its streams. */
    String getBoundary() {
        return boundary;
    }

    /** The product's name. */
    String getTitle() {
        return title;
    }

    /** The address of its stream, as programs for this product write it. */
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
