// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.grammar.ScriptText;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.readings.ScriptCameras;

/**
 * The cameras available to external programs. An export belongs to a camera's name, not to a simulation. It may be
 * created before a simulation, and stays open without pictures until a simulation with such a camera runs again. Any
 * thread.
 */
public final class CameraExports {
    /** Milliseconds without progress after which a client is dropped. */
    private static final long TIMEOUT = 10_000;

    private final Host host;
    private final ScriptCameras cameras;
    private final Map<String, NetworkCamera> made = new LinkedHashMap<>();

    public CameraExports(Host host, ScriptCameras cameras) {
        this.host = host;
        this.cameras = cameras;
    }

    /**
     * Creates a network camera; a repeated call returns the same one.
     *
     * @param number TCP port, 0 for any free one
     * @return the number
     * @throws IllegalArgumentException if the running simulation has no such camera; lists its cameras
     */
    public int plain(String camera, int number) throws IOException {
        return export(camera, number, DeviceProfile.PLAIN);
    }

    /** Creates a network camera with the addresses of a product. */
    public int like(String camera, int number, String product) throws IOException {
        return export(camera, number, DeviceProfile.of(ScriptText.of(product)));
    }

    private synchronized int export(String asked, int number, DeviceProfile profile) throws IOException {
        String camera = cameras.check(asked);
        String key = camera + ' ' + profile + ' ' + number;
        NetworkCamera present = made.get(key);
        if (present == null) {
            present = NetworkCamera.open(camera, profile, number, host, cameras, TIMEOUT);
            made.put(key, present);
        }
        return present.getNumber();
    }

    /** Warns of exports without a camera after the start of a simulation. */
    public synchronized void begin() {
        for (String camera : names()) {
            try {
                cameras.check(camera);
            } catch (IllegalArgumentException e) {
                host.warn("the export of camera " + camera + " does not work: " + e.getMessage());
            }
        }
    }

    private Set<String> names() {
        return made.values().stream().map(NetworkCamera::getCamera)
            .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    /** Returns descriptions of the exports, by camera name. */
    public synchronized Map<String, List<String>> list() {
        Map<String, List<String>> list = new LinkedHashMap<>();
        made.values().forEach(one -> list.computeIfAbsent(one.getCamera(), name -> new ArrayList<>())
            .add(one.describe()));
        return list;
    }

    /**
     * Ends all exports of a camera.
     *
     * @throws IllegalArgumentException with the exported cameras
     */
    public synchronized void end(String asked) {
        String camera = ScriptText.of(asked);
        if (!names().contains(camera)) {
            throw new IllegalArgumentException("camera " + (camera == null ? "None" : "\"" + camera + "\"")
                + " is not exported, legal: " + (made.isEmpty() ? "none" : String.join(", ", names())));
        }
        made.values().removeIf(one -> {
            boolean ends = one.getCamera().equals(camera);
            if (ends) {
                one.close();
            }
            return ends;
        });
    }

    /** Ends all exports. */
    public synchronized void close() {
        made.values().forEach(NetworkCamera::close);
        made.clear();
    }
}
